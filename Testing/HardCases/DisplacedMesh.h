// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The same mesh with its vertices moved by what the arithmetic of float amounts to
 */
#ifndef tetmarch_testing_DisplacedMesh_h
#define tetmarch_testing_DisplacedMesh_h

#include "Mesh/TetMesh.h"

#include "LatticeGrids.h"

#include <random>

namespace tetmarch::testing
{
/// How far a projected coordinate may be off, in mesh radii: 2^-21, derived in MarchCheck.h.
constexpr double ProjectionRounding = 4.76837158203125e-07;
/// Twice that, since both the vertex and the ray are rounded.
constexpr double VertexDisplacement = 2.0 * ProjectionRounding;

/// Every vertex at random within the given distance along each axis. The boxes of its hierarchy
/// keep their margin.
inline TetMesh displacedMesh(TetMesh mesh, double distance, unsigned seed)
{
  std::mt19937 random(seed);
  for (Vertex& v : mesh.Vertices)
  {
    for (float* x : { &v.X, &v.Y, &v.Z })
    {
      *x = static_cast<float>(double(*x) + distance * (2.0 * uniform(random) - 1.0));
    }
  }
  return mesh;
}
/// All vertices together: moved along one of 14 directions (the axes and the diagonals), or away
/// from the centre or towards it, so that none moves by more than the distance along an axis.
inline TetMesh displacedTogether(TetMesh mesh, double distance, int which)
{
  for (Vertex& v : mesh.Vertices)
  {
    float* x[3] = { &v.X, &v.Y, &v.Z };
    for (int k = 0; k < 3; ++k)
    {
      double step = 0.0;
      if (which < 6)
      {
        step = which / 2 == k ? (which % 2 == 0 ? 1.0 : -1.0) : 0.0;
      }
      else if (which < 14)
      {
        step = (which - 6) >> k & 1 ? 1.0 : -1.0;
      }
      else
      {
        step = (which % 2 == 0 ? 1.0 : -1.0) * double(*x[k]);
      }
      *x[k] = static_cast<float>(double(*x[k]) + distance * step);
    }
  }
  return mesh;
}
constexpr int DisplacementsTogether = 16;
} // namespace tetmarch::testing

#endif
