// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SliverGrids.h"

#include "CubeLattice.h"
#include "CubeTopology.h"
#include "PointMap.h"

#include "vtkCellType.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace tetmarch::testing
{
namespace
{
using Index3 = std::array<int, 3>;

Index3 indexOf(vtkIdType point, int n)
{
  const int id = static_cast<int>(point);
  return { id % (n + 1), id / (n + 1) % (n + 1), id / ((n + 1) * (n + 1)) };
}

// No cell has two of these points, so that each may move about in its own star of 24 tetrahedra.
bool isEvenInside(const Index3& index, int n)
{
  return std::all_of(
    index.begin(), index.end(), [n](int i) { return i > 0 && i < n && i % 2 == 0; });
}

int axisOf(const Index3& index) { return (index[0] + index[1] + index[2]) / 2 % 3; }

// The star of a point of Kuhn's lattice is the convex hull of the cubes [0, 1]^3 and [-1, 0]^3
// about it; this offset lies within its side at distance 1 along the axis, which two tetrahedra
// share.
Vec3 intoSideOfStar(int axis, double sign, double spacing)
{
  Vec3 offset;
  offset[axis] = sign * spacing;
  offset[(axis + 1) % 3] = sign * spacing / 2.0;
  offset[(axis + 2) % 3] = sign * spacing / 4.0;
  return offset;
}

Vec3 sum(const Vec3& a, const Vec3& b) { return { a[0] + b[0], a[1] + b[1], a[2] + b[2] }; }

Grid withFields(const Grid& grid, const Field& field)
{
  attachFields(grid, field);
  return grid;
}
} // namespace

Grid squashedLayers(int n, double squash, const Field& field)
{
  const Grid lattice = jitteredLattice(n);
  const auto height = [=](int k) { return k % 2 == 0 ? double(k) / n : (k + 1 - squash) / n; };
  return withFields(mapped(lattice,
                      [&](const Vec3& p, vtkIdType id) {
                        return Vec3{ p[0], p[1], height(indexOf(id, n)[2]) };
                      }),
    field);
}

Grid flatTetsInside(int n, const Field& field)
{
  const Grid lattice = jitteredLattice(n, 0.0);
  const auto move = [n](const Vec3& p, vtkIdType id)
  {
    const Index3 index = indexOf(id, n);
    const double sign = (index[0] + index[1]) % 4 == 0 ? 1.0 : -1.0;
    return isEvenInside(index, n) ? sum(p, intoSideOfStar(axisOf(index), sign, 1.0 / n)) : p;
  };
  return withFields(mapped(lattice, move), field);
}

Grid flatTetsOnBoundary(int n, const Field& field)
{
  const Grid lattice = jitteredLattice(n, 0.0);
  const auto move = [n](const Vec3& p, vtkIdType id)
  {
    const Index3 index = indexOf(id, n);
    const bool low = index[0] == 1;
    const bool moves = (low || index[0] == n - 1) && isEvenInside({ 2, index[1], index[2] }, n);
    return moves ? sum(p, intoSideOfStar(0, low ? -1.0 : 1.0, 1.0 / n)) : p;
  };
  return withFields(mapped(lattice, move), field);
}

Grid edgesWithoutLength(int n, const Field& field)
{
  const Grid lattice = jitteredLattice(n, 0.0);
  const auto move = [n](Vec3 p, vtkIdType id)
  {
    const Index3 index = indexOf(id, n);
    p[axisOf(index)] += isEvenInside(index, n) ? 1.0 / n : 0.0;
    return p;
  };
  return withFields(mapped(lattice, move), field);
}

Grid cellsWithRepeatedPoints(int n, const Field& field)
{
  CubeLattice lattice(n, 0.0);
  const auto neighbourOf = [n](vtkIdType point)
  {
    const Index3 index = indexOf(point, n);
    const vtkIdType strides[3] = { 1, n + 1, (n + 1) * (n + 1) };
    return point + (isEvenInside(index, n) ? strides[axisOf(index)] : 0);
  };
  lattice.forEachCube(
    [&](const Ids& cube)
    {
      for (const auto& tet : KuhnTets)
      {
        Ids points = pick(cube, tet);
        std::transform(points.begin(), points.end(), points.begin(), neighbourOf);
        lattice.Builder.addCell(VTK_TETRA, points);
      }
    });
  const Ids cube = lattice.cube(0, 0, 0);
  lattice.Builder.addCell(VTK_TETRA, { cube[0], cube[1], cube[1], cube[1] });
  lattice.Builder.addCell(VTK_TETRA, { cube[3], cube[3], cube[3], cube[3] });
  lattice.Builder.addCell(VTK_TETRA, { cube[0], cube[7], cube[0], cube[7] });
  return lattice.Builder.finish(field);
}

Grid needleFan(int tets, double height, const Field& field)
{
  GridBuilder builder;
  const vtkIdType low = builder.addPoint({ 0.0, 0.0, -height / 2.0 });
  const vtkIdType high = builder.addPoint({ 0.0, 0.0, height / 2.0 });
  Ids rim;
  for (int i = 0; i < tets; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / tets;
    rim.push_back(builder.addPoint({ std::cos(angle), std::sin(angle), 0.0 }));
  }
  for (int i = 0; i < tets; ++i)
  {
    builder.addCell(VTK_TETRA, { low, rim[i], rim[(i + 1) % tets], high });
  }
  return builder.finish(field);
}
} // namespace tetmarch::testing
