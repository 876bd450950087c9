// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TransferFunctionPreset.h"

#include "Failure.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

namespace
{
using nlohmann::json;
using tetmarch::Failure;

/// A field that is an array of tuples of finite numbers; empty if the field is missing.
std::vector<double> GetTuples(const json& preset, const std::string& field, std::size_t tupleSize)
{
  const auto found = preset.find(field);
  if (found == preset.end() || found->is_null())
  {
    return {};
  }
  if (!found->is_array() || found->size() % tupleSize != 0)
  {
    throw Failure(
      field + " must be an array of numbers, " + std::to_string(tupleSize) + " for each point");
  }
  std::vector<double> numbers;
  for (const json& element : *found)
  {
    if (!element.is_number() || !std::isfinite(element.get<double>()))
    {
      throw Failure(
        field + "[" + std::to_string(numbers.size()) + "] is " + element.dump() + ", not a number");
    }
    numbers.push_back(element.get<double>());
  }
  for (std::size_t i = tupleSize; i < numbers.size(); i += tupleSize)
  {
    if (!(numbers[i - tupleSize] <= numbers[i]))
    {
      throw Failure(field + "[" + std::to_string(i) +
                    "] is below the point before it; the points must "
                    "be in ascending order");
    }
  }
  return numbers;
}

bool GetFlag(const json& preset, const std::string& field)
{
  const auto found = preset.find(field);
  if (found == preset.end())
  {
    return false;
  }
  if (!found->is_boolean() && !found->is_number())
  {
    throw Failure(field + " must be 0, 1, true or false");
  }
  return found->is_boolean() ? found->get<bool>() : found->get<double>() != 0.0;
}

void SetColorSpace(vtkColorTransferFunction* color, const json& preset)
{
  static const std::map<std::string, int> spaces = { { "RGB", VTK_CTF_RGB }, { "HSV", VTK_CTF_HSV },
    { "Lab", VTK_CTF_LAB }, { "LAB", VTK_CTF_LAB }, { "CIELAB", VTK_CTF_LAB },
    { "Diverging", VTK_CTF_DIVERGING }, { "Lab/CIEDE2000", VTK_CTF_LAB_CIEDE2000 },
    { "Step", VTK_CTF_STEP } };
  const auto found = preset.find("ColorSpace");
  if (found == preset.end())
  {
    color->SetColorSpaceToRGB();
    return;
  }
  const auto space = found->is_string() ? spaces.find(found->get<std::string>()) : spaces.end();
  if (space == spaces.end())
  {
    throw Failure("ColorSpace is " + found->dump() +
                  "; known are RGB, HSV, Lab, CIELAB, Diverging, Lab/CIEDE2000 and Step");
  }
  color->SetColorSpace(space->second);
  color->SetHSVWrap(GetFlag(preset, "HSVWrap"));
}

/// Midpoint and sharpness of each colour point, which are ours alone; the usual ones if missing.
std::vector<double> GetColorShape(const json& preset, std::size_t points)
{
  std::vector<double> shape;
  for (std::size_t i = 0; i < points; ++i)
  {
    shape.insert(shape.end(), { 0.5, 0.0 });
  }
  const auto found = preset.find("RGBPointsShape");
  if (found == preset.end())
  {
    return shape;
  }
  const auto isShare = [](const json& element)
  { return element.is_number() && element.get<double>() >= 0.0 && element.get<double>() <= 1.0; };
  if (!found->is_array() || found->size() != shape.size() ||
      !std::all_of(found->begin(), found->end(), isShare))
  {
    throw Failure(
      "RGBPointsShape must be an array of numbers from 0 to 1, 2 for each point of RGBPoints");
  }
  return found->get<std::vector<double>>();
}

const json& GetFirstPreset(const json& document)
{
  if (document.is_array() && document.empty())
  {
    throw Failure("the array of presets is empty");
  }
  const json& preset = document.is_array() ? document[0] : document;
  if (!preset.is_object())
  {
    throw Failure("expected an array of presets, each an object with a field RGBPoints");
  }
  return preset;
}

tetmarch::TransferFunctions MakeFunctions(
  const json& preset, const std::optional<std::array<double, 2>>& range)
{
  const auto colors = GetTuples(preset, "RGBPoints", 4);
  const auto opacities = GetTuples(preset, "Points", 4);
  if (colors.empty())
  {
    throw Failure(preset.contains("IndexedColors")
                    ? "a preset of IndexedColors is for categories and can't colour a volume"
                    : "the field RGBPoints is missing or empty");
  }
  const double low = colors.front();
  const double high = colors[colors.size() - 4];
  const auto place = [&](double x)
  {
    // Where nothing is to be stretched, not a bit changes.
    return !range || ((*range)[0] == low && (*range)[1] == high) ? x
           : high > low ? (*range)[0] + (x - low) / (high - low) * ((*range)[1] - (*range)[0])
                        : (*range)[0];
  };

  tetmarch::TransferFunctions functions;
  functions.Color->SetAllowDuplicateScalars(true); // as ParaView does
  functions.Opacity->SetAllowDuplicateScalars(true);
  SetColorSpace(functions.Color, preset);
  const auto shape = GetColorShape(preset, colors.size() / 4);
  for (std::size_t i = 0; i < colors.size(); i += 4)
  {
    functions.Color->AddRGBPoint(place(colors[i]), colors[i + 1], colors[i + 2], colors[i + 3],
      shape[i / 2], shape[i / 2 + 1]);
  }
  for (std::size_t i = 0; i < opacities.size(); i += 4)
  {
    for (std::size_t k = 1; k < 4; ++k)
    {
      if (!(opacities[i + k] >= 0.0 && opacities[i + k] <= 1.0))
      {
        throw Failure("Points[" + std::to_string(i + k) + "] must be from 0 to 1");
      }
    }
    functions.Opacity->AddPoint(
      place(opacities[i]), opacities[i + 1], opacities[i + 2], opacities[i + 3]);
  }
  functions.HasOpacityOfItsOwn = !opacities.empty();
  if (opacities.empty())
  {
    functions.Opacity->AddPoint(place(low), 0.0);
    functions.Opacity->AddPoint(place(high), 1.0);
  }
  if (GetFlag(preset, "UseLogScale"))
  {
    if (!(place(low) > 0.0))
    {
      throw Failure(
        "UseLogScale asks for points above 0, but the first is at " + std::to_string(place(low)));
    }
    functions.Color->SetScaleToLog10();
  }
  const auto nan = preset.contains("NanColor") ? preset["NanColor"] : json::array({ 0.5, 0, 0 });
  if (!nan.is_array() || nan.size() != 3 || !nan[0].is_number() || !nan[1].is_number() ||
      !nan[2].is_number())
  {
    throw Failure("NanColor must be an array of three numbers");
  }
  functions.Color->SetNanColor(nan[0].get<double>(), nan[1].get<double>(), nan[2].get<double>());
  return functions;
}
} // namespace

namespace tetmarch
{

TransferFunctions ParsePreset(const std::string& text, const std::string& name,
  const std::optional<std::array<double, 2>>& range)
{
  try
  {
    return MakeFunctions(GetFirstPreset(json::parse(text)), range);
  }
  catch (const json::exception& error)
  {
    // "[json.exception.parse_error.101] parse error at line 3, column 5: ..."
    const std::string what = error.what();
    const auto bracket = what.find("] ");
    throw Failure(
      "preset '" + name + "': " + (bracket == std::string::npos ? what : what.substr(bracket + 2)));
  }
  catch (const Failure& failure)
  {
    throw Failure("preset '" + name + "': " + failure.what());
  }
}

TransferFunctions ReadPreset(
  const std::string& path, const std::optional<std::array<double, 2>>& range)
{
  std::ifstream file(path);
  std::stringstream text;
  if (!file || !(text << file.rdbuf()))
  {
    throw Failure("preset '" + path + "' can't be read");
  }
  return ParsePreset(text.str(), path, range);
}

} // namespace tetmarch
