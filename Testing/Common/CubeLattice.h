// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The cubes of a lattice in the unit cube, ready to be cut into cells
 */
#ifndef tetmarch_testing_CubeLattice_h
#define tetmarch_testing_CubeLattice_h

#include "GridBuilder.h"
#include "LatticeGrids.h"

namespace tetmarch::testing
{
/// The chosen ones of a list of points.
template <std::size_t Count>
Ids pick(const Ids& points, const int (&which)[Count])
{
  Ids picked;
  for (const int index : which)
  {
    picked.push_back(points[static_cast<std::size_t>(index)]);
  }
  return picked;
}

/// A builder that holds the points of latticePoints(n, warp, 1), and the corners of its cubes in
/// the order of CubeTopology.h.
class CubeLattice
{
public:
  CubeLattice(int n, double warp)
    : N(n)
  {
    const std::vector<double> points = latticePoints(n, warp, 1);
    for (std::size_t i = 0; i < points.size(); i += 3)
    {
      this->Builder.addPoint({ points[i], points[i + 1], points[i + 2] });
    }
  }

  Ids cube(int i, int j, int k) const
  {
    Ids corners;
    for (int b = 0; b < 8; ++b)
    {
      const vtkIdType x = i + (b & 1);
      const vtkIdType y = j + ((b >> 1) & 1);
      const vtkIdType z = k + (b >> 2);
      corners.push_back(x + (this->N + 1) * (y + (this->N + 1) * z));
    }
    return corners;
  }

  template <typename Visit>
  void forEachCube(Visit&& visit) const
  {
    for (int k = 0; k < this->N; ++k)
    {
      for (int j = 0; j < this->N; ++j)
      {
        for (int i = 0; i < this->N; ++i)
        {
          visit(this->cube(i, j, k));
        }
      }
    }
  }

  const int N;
  GridBuilder Builder;
};
} // namespace tetmarch::testing

#endif
