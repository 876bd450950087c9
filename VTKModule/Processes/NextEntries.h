// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The progress of a picture's rays in the piece of one process.
#ifndef TetMarchProcessesNextEntries_h
#define TetMarchProcessesNextEntries_h

#include "Processes/HiddenDepths.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetmarch
{

/** The bounding rectangle of some pixels, and their number. */
struct PixelBox
{
  int X = 0, Y = 0, Width = 0, Height = 0;
  std::size_t Pixels = 0;
};

/** For each pixel the depth of its ray's next entry into the piece. */
class NextEntries
{
public:
  /** An empty picture. */
  NextEntries() = default;
  /** All rays may enter anywhere. */
  NextEntries(int width, int height);

  void set(std::uint32_t pixel, float depth) { this->Depths[pixel] = depth; }
  void end(std::uint32_t pixel) { this->Depths[pixel] = NothingHidden; }
  /** End the rays whose next entry is hidden. Returns their number. */
  std::size_t endHidden(const HiddenDepths& hidden);
  /** Whether any ray enters again. */
  bool any() const;
  /** The box of the pixels whose next entry is not hidden. */
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
