// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Rays of pixels, in the arithmetic of the shader, and their lists of entries
 */
#ifndef tetmarch_testing_PixelLists_h
#define tetmarch_testing_PixelLists_h

#include "Entries/EntryLists.h"
#include "View/View.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace tetmarch::testing
{
struct PictureSize
{
  int Width;
  int Height;
};

/// The ray of a pixel (passes/pixel_ray.glsl); points: rayPoints() of the view.
template <typename Kernel>
typename Kernel::Ray rayOf(Kernel& kernel, const View& view, const std::array<double, 16>& points,
  const PictureSize& size, int column, int row)
{
  const float x = (float(column) + 0.5f) / float(size.Width) * 2.0f - 1.0f;
  const float y = (float(row) + 0.5f) / float(size.Height) * 2.0f - 1.0f;
  float p[4];
  for (int r = 0; r < 4; ++r)
  {
    const auto m = [&](int c) { return static_cast<float>(points[4 * r + c]); };
    p[r] = m(0) * x + m(1) * y + m(3);
  }
  const glsl::Vec3<float> point(p[0] / p[3], p[1] / p[3], p[2] / p[3]);
  const glsl::Vec3<float> eye(float(view.Eye[0]), float(view.Eye[1]), float(view.Eye[2]));
  return kernel.rayThrough(point, glsl::normalize(point * float(view.Eye[3]) - eye));
}

/// Give the ray of a pixel its list.
template <typename Kernel>
void useList(
  Kernel& kernel, const EntryLists& lists, int column, int row, typename Kernel::Ray& ray)
{
  const int shift = lists.TileShift;
  const int tile = (row >> shift) * lists.TilesPerRow + (column >> shift);
  const int last = (1 << shift) - 1;
  kernel.useEntryLists(lists);
  ray.firstCandidate = static_cast<int>(lists.First[tile]);
  ray.endOfCandidates = static_cast<int>(lists.First[tile + 1]);
  const int ofSquare = std::max(shift - 4, 0);
  ray.pixelInTile =
    static_cast<std::uint32_t>(((row & last) >> ofSquare) << 4 | ((column & last) >> ofSquare));
}
} // namespace tetmarch::testing

#endif
