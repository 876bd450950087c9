// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Processes/ExpectedDepths.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

// Share of the visits of a process: if fewer were hidden, it marches all.
constexpr double LeastHiddenShare = 0.125;

// Each depth becomes the maximum of its neighbours, since the occluders may have moved.
HiddenDepths spreadOut(HiddenDepths depths, int width, int height)
{
  for (const bool alongRows : { true, false })
  {
    const HiddenDepths from = depths;
    const std::size_t step = alongRows ? 1 : static_cast<std::size_t>(width);
    std::size_t at = 0;
    for (int y = 0; y < height; ++y)
    {
      for (int x = 0; x < width; ++x, ++at)
      {
        const bool isFirst = alongRows ? x == 0 : y == 0;
        const bool isLast = alongRows ? x + 1 == width : y + 1 == height;
        depths[at] = std::max(
          { isFirst ? from[at] : from[at - step], from[at], isLast ? from[at] : from[at + step] });
      }
    }
  }
  return depths;
}

} // namespace

void ExpectedDepths::begin(int width, int height)
{
  const bool isSame = width == this->Width && height == this->Height;
  const auto hidden = static_cast<double>(this->Hidden);
  const bool isMuch = hidden > LeastHiddenShare * static_cast<double>(this->Hidden + this->Seen);
  this->Expected.clear();
  if (isSame && isMuch)
  {
    this->Expected = spreadOut(this->Learned, width, height);
  }
  this->Width = width;
  this->Height = height;
  this->Learned.clear();
  this->Hidden = 0;
  this->Seen = 0;
}

HiddenDepths ExpectedDepths::ofRows(int first, int end) const
{
  return this->Expected.empty() ? HiddenDepths()
                                : HiddenDepths(this->Expected.begin() + this->startOf(first),
                                    this->Expected.begin() + this->startOf(end));
}

void ExpectedDepths::learn(int firstRow, const HiddenDepths& hidden)
{
  if (hidden.empty())
  {
    return;
  }
  this->Learned.resize(static_cast<std::size_t>(this->Width) * this->Height, NothingHidden);
  const auto rows = this->Learned.begin() + this->startOf(firstRow);
  std::transform(
    hidden.begin(), hidden.end(), rows, rows, [](float a, float b) { return std::min(a, b); });
}

void ExpectedDepths::count(
  int firstRow, const std::vector<VisitLists>& visits, std::size_t endedRays)
{
  this->Hidden += endedRays;
  for (const VisitLists& lists : visits)
  {
    const std::size_t hidden =
      this->Learned.empty() ? 0 : countHidden(lists, &this->Learned[this->startOf(firstRow)]);
    this->Hidden += hidden;
    this->Seen += lists.size() - hidden;
  }
}

} // namespace tetmarch
