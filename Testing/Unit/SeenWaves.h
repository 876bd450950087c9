// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Scalars and functions by which a part of any mesh is seen
 */
#ifndef tetmarch_testing_SeenWaves_h
#define tetmarch_testing_SeenWaves_h

#include "Mesh/TetMesh.h"

#include "MarchedMesh.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tetmarch::testing
{
/// Two waves along each axis.
inline void setWaves(TetMesh& mesh)
{
  for (Vertex& v : mesh.Vertices)
  {
    v.Scalar = 0.5f + 0.5f * std::sin(5.0f * v.X + 0.3f) * std::sin(4.0f * v.Y + 0.9f) *
                        std::cos(3.0f * v.Z);
  }
}

/// Colours everywhere, extinction above 0.8.
inline IntegralTable highTable()
{
  return tableOf(
    [](double f) {
      return std::array<double, 4>{ { f, 1.0 - f, 0.5, std::max(0.0, 40.0 * (f - 0.8)) } };
    });
}
} // namespace tetmarch::testing

#endif
