// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageFiles/NrrdAxes.h"

#include "ImageFiles/HeaderText.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace tetmarch
{
namespace
{

// One axis of the array.
struct NrrdAxis
{
  std::int64_t Size = 1;
  bool OfSpace = true;
  std::optional<ImageVector> Direction;
  double Spacing = 1;
  double First = 0; // the position of the first value
};

ImageVector vectorOf(const std::string& text)
{
  std::string numbers = text;
  std::replace(numbers.begin(), numbers.end(), ',', ' ');
  const std::vector<double> coordinates = realsOf("space directions", numbers, 0);
  if (coordinates.empty() || coordinates.size() > 3)
  {
    throw ImageFileError("a vector in its header has " + std::to_string(coordinates.size()) +
                         " coordinates; there can be 1 to 3");
  }
  ImageVector vector{};
  std::copy(coordinates.begin(), coordinates.end(), vector.begin());
  return vector;
}

// "(1,0,0) none (0,1,0)".
std::vector<std::optional<ImageVector>> vectorsOf(const std::string& text)
{
  std::vector<std::optional<ImageVector>> vectors;
  std::size_t at = 0;
  while ((at = text.find_first_not_of(" \t", at)) != std::string::npos)
  {
    const bool isVector = text[at] == '(';
    const std::size_t end =
      isVector ? text.find(')', at) : std::min(text.find_first_of(" \t(", at), text.size());
    const std::string part = text.substr(at, end - at);
    if (end == std::string::npos || (!isVector && lowered(part) != "none"))
    {
      throw ImageFileError("'" + shown(part) + "' in its header is no vector");
    }
    vectors.push_back(isVector ? std::optional(vectorOf(part.substr(1))) : std::nullopt);
    at = end + isVector;
  }
  return vectors;
}

bool isOfSpace(const std::string& kind)
{
  static const std::set<std::string> kinds = { "domain", "space", "none", "???" };
  return kinds.count(lowered(kind)) > 0;
}

// A field with one word per axis; empty if the header lacks it.
std::vector<std::string> wordsOfAxes(
  const NrrdFields& fields, const std::string& name, std::size_t axes)
{
  const std::string* text = fields.find(name);
  const std::vector<std::string> words = text ? wordsOf(*text) : std::vector<std::string>();
  if (text && words.size() != axes)
  {
    throw ImageFileError("the field '" + name + "' of its header has " +
                         std::to_string(words.size()) + " words for " + std::to_string(axes) +
                         " axes");
  }
  return words;
}

// Sets the spacings, given directly or by the ends of axes.
void setPlaces(const NrrdFields& fields, std::vector<NrrdAxis>& axes)
{
  const auto of = [&](const char* name)
  {
    const std::string* text = fields.find(name);
    return text ? realsOf(name, *text, axes.size()) : std::vector<double>(axes.size(), NAN);
  };
  const std::vector<double> spacings = of("spacings");
  const std::vector<double> first = of("axismins");
  const std::vector<double> last = of("axismaxs");
  auto centers = wordsOfAxes(fields, "centers", axes.size());
  centers = centers.empty() ? wordsOfAxes(fields, "centerings", axes.size()) : centers;
  for (std::size_t k = 0; k < axes.size(); ++k)
  {
    NrrdAxis& axis = axes[k];
    const bool ofNodes = !centers.empty() && lowered(centers[k]) == "node";
    const std::int64_t steps = std::max<std::int64_t>(axis.Size - (ofNodes ? 1 : 0), 1);
    const double byEnds = (last[k] - first[k]) / static_cast<double>(steps);
    axis.Spacing = !std::isnan(spacings[k]) ? spacings[k] : !std::isnan(byEnds) ? byEnds : 1.0;
    axis.First = std::isnan(first[k]) ? 0.0 : first[k] + (ofNodes ? 0.0 : axis.Spacing / 2);
  }
}

std::vector<NrrdAxis> axesOf(const NrrdFields& fields)
{
  const std::int64_t count = wholesOf("dimension", fields.get("dimension"), 1)[0];
  if (count < 1 || count > 16)
  {
    throw ImageFileError(
      "its header says that it has " + std::to_string(count) + " dimensions; there can be 1 to 16");
  }
  std::vector<NrrdAxis> axes(static_cast<std::size_t>(count));
  const auto sizes = wholesOf("sizes", fields.get("sizes"), axes.size());
  const auto kinds = wordsOfAxes(fields, "kinds", axes.size());
  for (std::size_t k = 0; k < axes.size(); ++k)
  {
    axes[k].Size = sizes[k];
    axes[k].OfSpace = kinds.empty() ? axes.size() != 4 || k > 0 : isOfSpace(kinds[k]);
  }
  setPlaces(fields, axes);
  if (const std::string* text = fields.find("spacedirections"))
  {
    const auto directions = vectorsOf(*text);
    if (directions.size() != axes.size())
    {
      throw ImageFileError("the field 'space directions' of its header has " +
                           std::to_string(directions.size()) + " vectors for " +
                           std::to_string(axes.size()) + " axes");
    }
    for (std::size_t k = 0; k < axes.size(); ++k)
    {
      axes[k].Direction = directions[k];
      axes[k].OfSpace = directions[k].has_value();
    }
  }
  return axes;
}

// Component axes come first, then up to three spatial axes; others have one value.
void takeAxes(const std::vector<NrrdAxis>& axes, ImageHeader& header)
{
  std::vector<NrrdAxis> ofSpace;
  const auto numberOfSpace =
    std::count_if(axes.begin(), axes.end(), [](const NrrdAxis& axis) { return axis.OfSpace; });
  for (const NrrdAxis& axis : axes)
  {
    if (axis.OfSpace && (axis.Size != 1 || numberOfSpace <= 3))
    {
      ofSpace.push_back(axis);
    }
    else if (axis.Size != 1 && (!ofSpace.empty() || header.Components != 1))
    {
      throw ImageFileError("an axis of " + std::to_string(axis.Size) +
                           " components is not the first one: write components together");
    }
    else if (axis.Size < 1 || axis.Size > 65536)
    {
      throw ImageFileError(
        "its header says that a value has " + std::to_string(axis.Size) + " components");
    }
    else
    {
      header.Components = static_cast<int>(axis.Size * header.Components);
    }
  }
  if (ofSpace.empty() || ofSpace.size() > 3)
  {
    throw ImageFileError("it has " + std::to_string(ofSpace.size()) +
                         " axes of space; images that are drawn have up to three");
  }
  std::vector<std::int64_t> sizes;
  std::vector<ImageVector> steps;
  for (std::size_t k = 0; k < ofSpace.size(); ++k)
  {
    ImageVector along{};
    along[k] = ofSpace[k].Spacing;
    sizes.push_back(ofSpace[k].Size);
    steps.push_back(ofSpace[k].Direction.value_or(along));
    header.Origin[k] = ofSpace[k].First;
  }
  setDimensions(header, sizes);
  setSteps(header, steps);
}

} // namespace

void setNrrdAxes(const NrrdFields& fields, ImageHeader& header)
{
  takeAxes(axesOf(fields), header);
  if (const std::string* origin = fields.find("spaceorigin"))
  {
    const auto places = vectorsOf(*origin);
    if (places.size() != 1 || !places[0])
    {
      throw ImageFileError("the field 'space origin' of its header is no vector");
    }
    header.Origin = *places[0];
  }
}

} // namespace tetmarch
