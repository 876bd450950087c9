// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// How far the rays of a picture have got in the piece of one process.
#ifndef TetMarchProcessesNextEntries_h
#define TetMarchProcessesNextEntries_h

#include "Processes/HiddenDepths.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetmarch
{

/** The least rectangle that has some pixels, and how many these are. */
struct PixelBox
{
  int X = 0, Y = 0, Width = 0, Height = 0;
  std::size_t Pixels = 0;
};

/** Of each pixel the depth at which its ray enters the piece next. */
class NextEntries
{
public:
  /** Of no picture: no ray enters. */
  NextEntries() = default;
  /** All rays may enter anywhere. */
  NextEntries(int width, int height);

  void set(std::uint32_t pixel, float depth) { this->Depths[pixel] = depth; }
  void end(std::uint32_t pixel) { this->Depths[pixel] = NothingHidden; }
  /** The rays that enter where that is hidden end. Returns how many. */
  std::size_t endHidden(const HiddenDepths& hidden);
  /** Whether a ray enters again. */
  bool any() const;
  /** Of the pixels whose rays enter where that is not hidden. */
  PixelBox boxOfSeen(const HiddenDepths& hidden) const;

private:
  bool isHidden(std::size_t pixel, const HiddenDepths& hidden) const
  {
    return !hidden.empty() && this->Depths[pixel] > hidden[pixel];
  }

  int Width = 0;
  int Height = 0;
  std::vector<float> Depths; // NothingHidden: the ray has ended
};

} // namespace tetmarch

#endif
