// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Processes/HiddenDepths.h"

#include "Processes/PixelSpan.h"

#include <algorithm>

namespace tetmarch
{

void packHidden(const MergedPixel* row, int width, Packer& packer)
{
  const PixelSpan span = spanOf(static_cast<std::uint32_t>(width),
    [&](std::uint32_t x) { return row[x].HiddenFrom < NothingHidden; });
  packer.add(&span, 1);
  for (std::uint32_t x = span.First; x < span.End; ++x)
  {
    packer.add(&row[x].HiddenFrom, 1);
  }
}

void takeHidden(Unpacker& sent, int width, float* row)
{
  const PixelSpan span = takeSpan(sent, static_cast<std::uint32_t>(width));
  for (std::uint32_t x = span.First; x < span.End; ++x)
  {
    float depth = NothingHidden;
    sent.take(&depth, 1);
    row[x] = std::min(row[x], depth);
  }
}

std::size_t countHidden(const VisitLists& lists, const float* hidden)
{
  std::size_t count = 0;
  const auto pixels = static_cast<std::uint32_t>(lists.width() * lists.height());
  for (std::uint32_t pixel = 0; pixel < pixels; ++pixel)
  {
    count += static_cast<std::size_t>(std::count_if(lists.begin(pixel), lists.end(pixel),
      [&](const Visit& visit) { return visit.Begin > hidden[pixel]; }));
  }
  return count;
}

} // namespace tetmarch
