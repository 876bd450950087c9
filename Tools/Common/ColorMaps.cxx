// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ColorMaps.h"

#include "ColorMapText.h"
#include "Failure.h"
#include "TransferFunctionPreset.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace
{
using nlohmann::json;

struct ColorMap
{
  std::string Name;
  tetmarch::TransferFunctions Functions; ///< from 0 to 1; of these, the colours
};

std::vector<ColorMap> ReadMaps()
{
  std::vector<ColorMap> maps;
  for (const json& preset : json::parse(tetmarch::ColorMapText))
  {
    const auto name = preset["Name"].get<std::string>();
    maps.push_back({ name, tetmarch::ParsePreset(preset.dump(), name) });
  }
  return maps;
}

const std::vector<ColorMap>& GetMaps()
{
  static const std::vector<ColorMap> maps = ReadMaps();
  return maps;
}

std::string Simplify(const std::string& name)
{
  std::string simple;
  for (const char character : name)
  {
    const auto byte = static_cast<unsigned char>(character);
    if (!std::isspace(byte))
    {
      simple += static_cast<char>(std::tolower(byte));
    }
  }
  const std::string origin = "(matplotlib)";
  const auto found = simple.find(origin);
  return found == std::string::npos ? simple : simple.erase(found, origin.size());
}
} // namespace

namespace tetmarch
{

std::vector<std::string> GetColorMapNames()
{
  std::vector<std::string> names;
  for (const ColorMap& map : GetMaps())
  {
    names.push_back(map.Name);
  }
  return names;
}

bool ApplyColorMap(
  const std::string& name, double low, double high, vtkColorTransferFunction* color)
{
  if (!std::isfinite(low) || !std::isfinite(high))
  {
    throw Failure("a colour map needs a finite range, but was given " + std::to_string(low) +
                  " to " + std::to_string(high));
  }
  const auto& maps = GetMaps();
  const auto map = std::find_if(maps.begin(), maps.end(),
    [&](const ColorMap& candidate) { return Simplify(candidate.Name) == Simplify(name); });
  if (map == maps.end())
  {
    return false;
  }
  vtkColorTransferFunction* const unit = map->Functions.Color;
  if (low > high)
  {
    std::swap(low, high);
  }
  const bool logarithmic = color->GetScale() == VTK_CTF_LOG10 && low > 0.0;
  color->RemoveAllPoints();
  color->SetColorSpace(unit->GetColorSpace());
  color->SetScale(logarithmic ? VTK_CTF_LOG10 : VTK_CTF_LINEAR);
  color->SetNanColor(unit->GetNanColor());
  if (low == high)
  {
    double rgb[3];
    unit->GetColor(0.5, rgb);
    color->AddRGBPoint(low, rgb[0], rgb[1], rgb[2]);
    return true;
  }
  const int last = unit->GetSize() - 1;
  for (int i = 0; i <= last; ++i)
  {
    double node[6];
    unit->GetNodeValue(i, node);
    // The ends exactly, or the range would not be what was asked for.
    const double x = i == 0        ? low
                     : i == last   ? high
                     : logarithmic ? low * std::pow(high / low, node[0])
                                   : low + node[0] * (high - low);
    color->AddRGBPoint(x, node[1], node[2], node[3], node[4], node[5]);
  }
  return true;
}

std::string DescribeUnknownColorMap(const std::string& name)
{
  std::string known;
  for (const std::string& each : GetColorMapNames())
  {
    known += (known.empty() ? "" : ", ") + each;
  }
  return "there is no colour map '" + name + "'; known are " + known;
}

} // namespace tetmarch
