// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Compares views of boundary faces whatever the numbers of the vertices
 *
 * The colour of a face, and the order of its corners, follow from the numbers of its vertices in
 * the mesh. A mesh keeps these while its points move, a mesh that is built of the moved points
 * orders its vertices by where they are now. So views of both show the same faces in other colours.
 */
#ifndef tetmarch_testing_SameFaces_h
#define tetmarch_testing_SameFaces_h

#include "Images.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace tetmarch::testing
{
/// Pixels of VIEW_BOUNDARY_FACES in which two views of one size show different faces: all that are
/// not of the colour in b that most pixels of their colour in a have, or the other way around.
inline std::size_t countOtherFaces(const Image& a, const Image& b)
{
  using Color = std::array<float, 4>;
  const auto others = [](const Image& from, const Image& to)
  {
    std::map<Color, std::map<Color, std::size_t>> seen;
    for (std::size_t i = 0; i < from.Rgba.size(); i += 4)
    {
      const float* f = &from.Rgba[i];
      const float* t = &to.Rgba[i];
      ++seen[{ { f[0], f[1], f[2], f[3] } }][{ { t[0], t[1], t[2], t[3] } }];
    }
    std::size_t count = 0;
    for (const auto& [color, partners] : seen)
    {
      std::size_t most = 0;
      for (const auto& [partner, pixels] : partners)
      {
        count += pixels;
        most = std::max(most, pixels);
      }
      count -= most;
    }
    return count;
  };
  return std::max(others(a, b), others(b, a));
}

/// Views of VIEW_BOUNDARY_COORDINATES become equal if the corners of faces have another order.
inline Image withSortedColors(Image image)
{
  for (std::size_t i = 0; i < image.Rgba.size(); i += 4)
  {
    std::sort(&image.Rgba[i], &image.Rgba[i] + 3);
  }
  return image;
}
} // namespace tetmarch::testing

#endif
