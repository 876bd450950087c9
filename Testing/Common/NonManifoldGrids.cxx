// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "NonManifoldGrids.h"

#include "CubeLattice.h"
#include "CubeTopology.h"

#include "vtkCellType.h"
#include "vtkMath.h"

#include <cmath>
#include <random>

namespace tetmarch::testing
{
namespace
{
// The corners, in the order of CubeTopology.h, of a cube with that edge.
Ids cubeAt(GridBuilder& builder, int i, int j, int k, int edge)
{
  Ids corners;
  for (int b = 0; b < 8; ++b)
  {
    corners.push_back(
      builder.at(i + (b & 1) * edge, j + ((b >> 1) & 1) * edge, k + (b >> 2) * edge));
  }
  return corners;
}

void addKuhnTets(GridBuilder& builder, const Ids& cube)
{
  for (const auto& tet : KuhnTets)
  {
    builder.addCell(VTK_TETRA, pick(cube, tet));
  }
}
} // namespace

Grid faceOfThreeTets(const Field& field)
{
  GridBuilder builder;
  for (const Vec3& p : std::vector<Vec3>{
         { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0, 0, -1 }, { 0.1, 0.1, 0.5 } })
  {
    builder.addPoint(p);
  }
  builder.addCell(VTK_TETRA, { 0, 1, 2, 3 });
  builder.addCell(VTK_TETRA, { 0, 2, 1, 4 });
  builder.addCell(VTK_TETRA, { 0, 1, 2, 5 });
  return builder.finish(field);
}

Grid latticeWithThirdOwners(int n, const Field& field)
{
  CubeLattice lattice(n, 0.0);
  GridBuilder& builder = lattice.Builder;
  lattice.forEachCube([&](const Ids& cube) { addKuhnTets(builder, cube); });
  lattice.forEachCube(
    [&](const Ids& cube)
    {
      // Tetrahedra 0-1-3-7 and 0-3-2-7 meet in 0-3-7.
      const Vec3 p = builder.position(cube[5]);
      const vtkIdType tip =
        builder.addPoint({ p[0] + 0.25 / n, p[1] - 0.375 / n, p[2] + 0.125 / n });
      builder.addCell(VTK_TETRA, { cube[0], cube[3], cube[7], tip });
    });
  return builder.finish(field);
}

Grid hangingNodes(int n, double bulge, const Field& field)
{
  const double fine = 0.5 / n;
  GridBuilder builder({ fine, fine, fine });
  for (int k = 0; k < 2 * n; k += 2)
  {
    for (int j = 0; j < 2 * n; j += 2)
    {
      for (int i = 0; i < n; i += 2)
      {
        addKuhnTets(builder, cubeAt(builder, i, j, k, 2));
      }
    }
  }
  for (int k = 0; k < 2 * n; ++k)
  {
    for (int j = 0; j < 2 * n; ++j)
    {
      for (int i = n; i < 2 * n; ++i)
      {
        addKuhnTets(builder, cubeAt(builder, i, j, k, 1));
      }
      if (bulge != 0.0 && (j % 2 != 0 || k % 2 != 0))
      {
        const double side = (j + k) % 4 < 2 ? 1.0 : -1.0;
        builder.move(builder.at(n, j, k), { 0.5 + side * bulge * fine, j * fine, k * fine });
      }
    }
  }
  return builder.finish(field);
}

Grid refinedCubes(int n, unsigned oneIn, unsigned seed, const Field& field)
{
  std::mt19937 random(seed);
  const double fine = 0.5 / n;
  GridBuilder builder({ fine, fine, fine });
  for (int k = 0; k < 2 * n; k += 2)
  {
    for (int j = 0; j < 2 * n; j += 2)
    {
      for (int i = 0; i < 2 * n; i += 2)
      {
        const int edge = random() % oneIn == 0 ? 1 : 2;
        for (int b = 0; b < 8 / (edge * edge * edge); ++b)
        {
          addKuhnTets(builder, cubeAt(builder, i + (b & 1), j + (b >> 1 & 1), k + (b >> 2), edge));
        }
      }
    }
  }
  return builder.finish(field);
}

Grid moebiusRing(int segments, const Field& field)
{
  GridBuilder builder;
  for (int s = 0; s < segments; ++s)
  {
    const double turn = 2.0 * vtkMath::Pi() * s / segments;
    const auto place = [&](double across, double above)
    {
      const double c = std::cos(turn / 2.0);
      const double d = std::sin(turn / 2.0);
      const double radius = 1.0 + c * across - d * above;
      builder.addPoint(
        { radius * std::cos(turn), radius * std::sin(turn), d * across + c * above });
    };
    place(-0.5, 0.0);
    place(0.5, 0.0);
    place(0.0, 0.1);
  }
  const auto pointOf = [segments](int index)
  {
    const int swapped[3] = { 1, 0, 2 };
    const int number = index < 3 * segments ? index : swapped[index % 3];
    return static_cast<vtkIdType>(number);
  };
  for (int i = 0; i < 3 * segments; ++i)
  {
    builder.addCell(VTK_TETRA, { pointOf(i), pointOf(i + 1), pointOf(i + 2), pointOf(i + 3) });
  }
  return builder.finish(field);
}
} // namespace tetmarch::testing
