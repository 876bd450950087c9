// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Optics/TableTraits.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

using Entries = std::vector<std::array<float, 4>>;

std::array<float, 4> transparentRanges(const Entries& entries)
{
  std::array<float, 4> ranges = TableTraits::NothingTransparent;
  const auto isSeen = [](const std::array<float, 4>& entry) { return entry[3] > 0; };
  const auto positionOf = [&](Entries::const_iterator entry)
  { return static_cast<float>(entry - entries.begin()); };
  float widest = 0;
  for (auto begin = entries.begin(); begin != entries.end();)
  {
    const auto first = std::find_if_not(begin, entries.end(), isSeen);
    const auto end = std::find_if(first, entries.end(), isSeen);
    if (first != end)
    {
      const float from = positionOf(first);
      const float to = positionOf(end) - 1;
      const bool isGap = first != entries.begin() && end != entries.end();
      ranges[0] = first == entries.begin() ? to : ranges[0];
      ranges[1] = end == entries.end() ? from : ranges[1];
      if (isGap && to - from > widest)
      {
        widest = to - from;
        ranges[2] = from;
        ranges[3] = to;
      }
    }
    begin = end;
  }
  return ranges;
}

} // namespace

TableTraits traitsOf(const Entries& entries)
{
  TableTraits traits;
  traits.Transparent = transparentRanges(entries);
  traits.ConstantColor = std::all_of(entries.begin(), entries.end(),
    [&](const std::array<float, 4>& entry)
    { return std::equal(entry.begin(), entry.begin() + 3, entries.front().begin()); });
  return traits;
}

} // namespace tetmarch
