// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scalars/SeenScalars.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace tetmarch
{
namespace
{

// Relative rounding of stored scalars and their positions in a table.
constexpr double Rounding = 1e-6;

double roundingOf(double scalar) { return Rounding * std::min(scalar, 1 - scalar); }

float floatOf(std::uint32_t bits)
{
  float value = 0;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

// The least stored scalar from which on a condition holds; above 1 if it holds for none. The bits
// of floats from 0 on ascend as their values do.
template <typename Condition>
float leastWith(const Condition& holds)
{
  std::uint32_t least = 0;
  std::uint32_t end = 0x3f800001u; // that of 1 is one less
  while (least < end)
  {
    const std::uint32_t middle = least + (end - least) / 2;
    if (holds(double(floatOf(middle))))
    {
      end = middle;
    }
    else
    {
      least = middle + 1;
    }
  }
  return floatOf(least);
}

// The greatest one up to which it holds; below 0 if it holds for none.
template <typename Condition>
float greatestWith(const Condition& holds)
{
  return std::nextafter(leastWith([&](double scalar) { return !holds(scalar); }), -1.0f);
}

} // namespace

SeenScalars::SeenScalars(const IntegralTable& table, const ScalarRange& range)
  : Scale(table.scale(range.width()))
  , Offset(table.offset(range.Low))
  , Before(table.Values.size() + 1)
{
  for (std::size_t i = 0; i < table.Values.size(); ++i)
  {
    this->Before[i + 1] = this->Before[i] + (table.Values[i][3] > 0 ? 1 : 0);
  }
}

// Between entries the extinction is linear: it is above 0 only within one entry of an entry with
// extinction. Scalars may be rounded, except 0 and 1, the ends of the range: these are exact, so
// that transparent ends stay transparent.
std::size_t SeenScalars::firstEntry(double low) const
{
  return this->entryOf(std::floor(this->positionOf(low - roundingOf(low))));
}

std::size_t SeenScalars::lastEntry(double high) const
{
  return this->entryOf(std::ceil(this->positionOf(high + roundingOf(high))));
}

bool SeenScalars::between(double low, double high) const
{
  return low <= high &&
         this->Before[this->lastEntry(high) + 1] > this->Before[this->firstEntry(low)];
}

std::vector<SeenRun> SeenScalars::runs() const
{
  std::vector<SeenRun> runs;
  const std::size_t entries = this->Before.size() - 1;
  const auto isSeen = [this](std::size_t entry)
  { return this->Before[entry + 1] > this->Before[entry]; };
  for (std::size_t first = 0; first < entries; ++first)
  {
    if (isSeen(first))
    {
      std::size_t last = first;
      while (last + 1 < entries && isSeen(last + 1))
      {
        ++last;
      }
      runs.push_back({ leastWith([&](double high) { return this->lastEntry(high) >= first; }),
        greatestWith([&](double low) { return this->firstEntry(low) <= last; }) });
      first = last;
    }
  }
  return runs;
}

std::size_t SeenScalars::entryOf(double position) const
{
  return static_cast<std::size_t>(
    std::clamp(position, 0.0, static_cast<double>(this->Before.size() - 2)));
}

bool isAnyBetween(const std::vector<float>& values, double low, double high)
{
  const auto first = std::lower_bound(values.begin(), values.end(), low - Rounding,
    [](float v, double limit) { return double(v) < limit; });
  return first != values.end() && double(*first) <= high + Rounding;
}

std::vector<SeenRun> runsAround(const std::vector<float>& values)
{
  std::vector<SeenRun> runs;
  for (const double value : values)
  {
    runs.push_back({ leastWith([&](double high) { return value <= high + Rounding; }),
      greatestWith([&](double low) { return value >= low - Rounding; }) });
  }
  return runs;
}

} // namespace tetmarch
