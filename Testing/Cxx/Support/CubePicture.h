// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A picture of a cube of constant extinction, against the closed form of each pixel
 */
#ifndef tetmarch_testing_CubePicture_h
#define tetmarch_testing_CubePicture_h

#include "Images.h"
#include "Unprojection.h"

#include "ClosedForms.h"

#include <gtest/gtest.h>
#include <iostream>
#include <string>

namespace tetmarch::testing
{
/// The rasteriser knows where edges are to 1/256 of a pixel, here 1e-4 of the cube's edge: beside
/// one, a chord may be off by a few times as much.
constexpr double MostCubeError = 3e-4;

/// Expects the opacities of a unit cube in the world, given by its lowest corner, and at least so
/// many pixels that show it. Prints the greatest error.
inline void expectCube(const Image& drawn, vtkCamera* camera, const Vec3& corner, double extinction,
  int leastPixels, const std::string& what = {})
{
  const Unprojection unproject(camera, double(drawn.Width) / drawn.Height);
  const Vec3 far{ corner[0] + 1.0, corner[1] + 1.0, corner[2] + 1.0 };
  double most = 0.0;
  int seen = 0;
  for (int row = 0; row < drawn.Height; ++row)
  {
    for (int column = 0; column < drawn.Width; ++column)
    {
      const double x = (column + 0.5) / drawn.Width * 2.0 - 1.0;
      const double y = (row + 0.5) / drawn.Height * 2.0 - 1.0;
      const Vec3 from = unproject(x, y, -1.0), to = unproject(x, y, 1.0);
      const double length =
        boxChord(from, { to[0] - from[0], to[1] - from[1], to[2] - from[2] }, corner, far, 0.0);
      const double opacity = slabOpacity(extinction, length);
      most = std::max(most, std::abs(opacity - double(drawn.pixel(column, row)[3])));
      seen += length > 0.0 ? 1 : 0;
    }
  }
  std::cout << "[ MEASURED ] " << what << " greatest error of opacity " << most << '\n';
  EXPECT_LE(most, MostCubeError) << what;
  EXPECT_GE(seen, leastPixels) << what;
}
} // namespace tetmarch::testing

#endif
