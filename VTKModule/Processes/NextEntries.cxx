// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Processes/NextEntries.h"

#include <algorithm>

namespace tetmarch
{

NextEntries::NextEntries(int width, int height)
  : Width(width)
  , Height(height)
  , Depths(static_cast<std::size_t>(width) * height, -NothingHidden)
{
}

std::size_t NextEntries::endHidden(const HiddenDepths& hidden)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < this->Depths.size(); ++i)
  {
    if (this->Depths[i] < NothingHidden && this->isHidden(i, hidden))
    {
      this->Depths[i] = NothingHidden;
      ++count;
    }
  }
  return count;
}

bool NextEntries::any() const
{
  return std::any_of(
    this->Depths.begin(), this->Depths.end(), [](float depth) { return depth < NothingHidden; });
}

PixelBox NextEntries::boxOfSeen(const HiddenDepths& hidden) const
{
  int left = this->Width, right = -1, bottom = this->Height, top = -1;
  std::size_t pixels = 0;
  std::size_t i = 0;
  for (int y = 0; y < this->Height; ++y)
  {
    for (int x = 0; x < this->Width; ++x, ++i)
    {
      if (this->Depths[i] < NothingHidden && !this->isHidden(i, hidden))
      {
        left = std::min(left, x);
        right = std::max(right, x);
        bottom = std::min(bottom, y);
        top = y;
        ++pixels;
      }
    }
  }
  return pixels == 0 ? PixelBox{}
                     : PixelBox{ left, bottom, right + 1 - left, top + 1 - bottom, pixels };
}

} // namespace tetmarch
