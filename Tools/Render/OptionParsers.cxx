// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OptionParsers.h"

#include "Failure.h"
#include "Numbers.h"
#include "OptionValues.h"

#include <algorithm>

namespace tetmarch
{

namespace
{

constexpr int MaximumSize = 16384;

void CheckChannels(const std::vector<double>& channels, const std::string& count)
{
  for (const double channel : channels)
  {
    if (!(channel >= 0.0 && channel <= 1.0))
    {
      throw UsageError("expected " + count + " numbers from 0 to 1");
    }
  }
}

} // namespace

std::array<int, 2> ParseSize(const std::string& value)
{
  const auto x = value.find('x');
  if (x != std::string::npos)
  {
    const auto width = ParseInteger(value.substr(0, x));
    const auto height = ParseInteger(value.substr(x + 1));
    if (width && height && *width >= 1 && *height >= 1 && *width <= MaximumSize &&
        *height <= MaximumSize)
    {
      return { { *width, *height } };
    }
  }
  throw UsageError("expected WIDTHxHEIGHT, each from 1 to " + std::to_string(MaximumSize));
}

std::array<int, 2> ParsePixel(const std::string& value)
{
  const auto comma = value.find(',');
  if (comma != std::string::npos)
  {
    const auto x = ParseInteger(value.substr(0, comma));
    const auto y = ParseInteger(value.substr(comma + 1));
    if (x && y && *x >= 0 && *y >= 0)
    {
      return { { *x, *y } };
    }
  }
  throw UsageError("expected X,Y, two whole numbers, 0 or more");
}

std::array<double, 3> ParseColor(const std::string& value)
{
  const auto rgb = ParseList(value, { 3 });
  CheckChannels(rgb, "three");
  return { { rgb[0], rgb[1], rgb[2] } };
}

std::array<double, 2> ParseRange(const std::string& value)
{
  const auto range = ParseList(value, { 2 });
  if (!(range[0] < range[1]))
  {
    throw UsageError("the first number must be below the second");
  }
  return { { range[0], range[1] } };
}

CameraOption ParseCamera(const std::string& value)
{
  const auto n = ParseList(value, { 9, 10 });
  CameraOption camera;
  camera.Position = { { n[0], n[1], n[2] } };
  camera.FocalPoint = { { n[3], n[4], n[5] } };
  camera.ViewUp = { { n[6], n[7], n[8] } };
  const double direction[3] = { n[3] - n[0], n[4] - n[1], n[5] - n[2] };
  const double cross[3] = { direction[1] * n[8] - direction[2] * n[7],
    direction[2] * n[6] - direction[0] * n[8], direction[0] * n[7] - direction[1] * n[6] };
  if (cross[0] == 0.0 && cross[1] == 0.0 && cross[2] == 0.0)
  {
    throw UsageError("position and focal point coincide, or the view-up vector is zero or parallel "
                     "to the line of sight");
  }
  if (n.size() == 10)
  {
    if (!(n[9] > 0.0 && n[9] < 180.0))
    {
      throw UsageError("the view angle must be above 0 and below 180 degrees");
    }
    camera.ViewAngle = n[9];
  }
  return camera;
}

std::vector<double> ParseNanColor(const std::string& value)
{
  auto rgba = ParseList(value, { 3, 4 });
  CheckChannels(rgba, "three or four");
  rgba.resize(4, 1.0);
  return rgba;
}

std::vector<std::array<double, 2>> ParseGradientOpacity(const std::string& value)
{
  const auto numbers = ParseNumbers(value, ',');
  if (!numbers || numbers->empty() || numbers->size() % 2 != 0)
  {
    throw UsageError("expected finite numbers separated by commas, in pairs");
  }
  std::vector<std::array<double, 2>> points;
  for (std::size_t i = 0; i < numbers->size(); i += 2)
  {
    const double magnitude = (*numbers)[i];
    const double opacity = (*numbers)[i + 1];
    if (magnitude < 0.0 || opacity < 0.0 || opacity > 1.0)
    {
      throw UsageError("expected magnitudes of 0 or more, and opacities from 0 to 1");
    }
    points.push_back({ { magnitude, opacity } });
  }
  return points;
}

int ParseComponent(const std::string& value)
{
  return value == "magnitude" ? -1 : ParseCount(value);
}

TimeRange ParseTimeRange(const std::string& value)
{
  if (value == "all")
  {
    return {};
  }
  const auto colon = value.find(':');
  if (colon != std::string::npos)
  {
    const auto first = ParseInteger(value.substr(0, colon));
    const auto last = ParseInteger(value.substr(colon + 1));
    if (first && last && *first >= 0 && *first <= *last)
    {
      return { *first, *last };
    }
  }
  throw UsageError("expected all or FROM:TO, two time steps, the first not after the second");
}

int ParseWholeWithin(const std::string& value, int least, int most)
{
  const auto number = ParseInteger(value);
  if (!number || *number < least || *number > most)
  {
    throw UsageError(
      "expected a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  }
  return *number;
}

} // namespace tetmarch
