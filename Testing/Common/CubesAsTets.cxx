// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CubesAsTets.h"

#include "CubeTopology.h"

#include "vtkCellType.h"

#include <cmath>

namespace tetmarch::testing
{
Grid cubesAsTets(const std::vector<Cube>& cubes, const Field& field, const Placement& place,
  const std::function<Cube(const Cube&)>& name)
{
  GridBuilder builder;
  for (const Cube& cube : cubes)
  {
    Ids corners;
    for (int b = 0; b < 8; ++b)
    {
      const Cube corner{ cube[0] + (b & 1), cube[1] + (b >> 1 & 1), cube[2] + (b >> 2) };
      const Cube named = name(corner);
      corners.push_back(builder.at(named[0], named[1], named[2]));
      builder.move(corners.back(), place(named));
    }
    for (const auto& tet : KuhnTets)
    {
      builder.addCell(
        VTK_TETRA, { corners[tet[0]], corners[tet[1]], corners[tet[2]], corners[tet[3]] });
    }
  }
  return builder.finish(field);
}

Grid comb(int teeth, const Field& field)
{
  std::vector<Cube> cubes;
  for (int i = 0; i < 2 * teeth - 1; ++i)
  {
    cubes.push_back({ i, 0, 0 });
    if (i % 2 == 0)
    {
      cubes.push_back({ i, 1, 0 });
    }
  }
  const double width = 1.0 / (2 * teeth - 1);
  return cubesAsTets(cubes, field,
    [=](const Cube& c) {
      return Vec3{ width * c[0], 20.0 * width * c[1], 20.0 * width * c[2] };
    });
}

Grid torus(int segments, const Field& field)
{
  std::vector<Cube> cubes;
  for (int i = 0; i < segments; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      for (int k = 0; k < 3; ++k)
      {
        cubes.push_back({ i, j, k });
      }
    }
  }
  const auto place = [=](const Cube& c)
  {
    // The square to the disc, rings of the square to circles.
    const double u = (c[1] - 1.5) / 1.5, v = (c[2] - 1.5) / 1.5;
    const double length = std::hypot(u, v);
    const double scale = 0.4 * std::max(std::abs(u), std::abs(v)) / length;
    const double angle = 6.283185307179586 * c[0] / segments;
    const double ring = 1.0 + scale * u;
    return Vec3{ ring * std::cos(angle), ring * std::sin(angle), scale * v };
  };
  return cubesAsTets(cubes, field, place,
    [=](const Cube& c) {
      return Cube{ c[0] % segments, c[1], c[2] };
    });
}

Grid sheets(int slabs, int n, double gap, const Field& field)
{
  std::vector<Cube> cubes;
  for (int s = 0; s < slabs; ++s)
  {
    for (int i = 0; i < n; ++i)
    {
      for (int j = 0; j < n; ++j)
      {
        cubes.push_back({ i, j, 2 * s });
      }
    }
  }
  return cubesAsTets(cubes, field,
    [=](const Cube& c)
    {
      const int slab = c[2] / 2;
      const double thickness = 1.0 / slabs - gap;
      return Vec3{ static_cast<double>(c[0]) / n, static_cast<double>(c[1]) / n,
        static_cast<double>(slab) / slabs + (c[2] % 2 ? thickness : 0.0) };
    });
}

Grid spiral(int turns, const Field& field)
{
  std::vector<Cube> cubes{ { 0, 0, 0 } };
  Cube at{ 0, 0, 0 };
  const int step[4][2] = { { 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } };
  for (int side = 0; side < 4 * turns; ++side)
  {
    for (int i = 0; i < 2 * (side / 2 + 1); ++i)
    {
      at[0] += step[side % 4][0];
      at[1] += step[side % 4][1];
      cubes.push_back(at);
    }
  }
  const double size = 1.0 / (4 * turns + 1);
  return cubesAsTets(cubes, field,
    [=](const Cube& c) {
      return Vec3{ 0.5 + size * c[0], 0.5 + size * c[1], 4.0 * size * c[2] };
    });
}
} // namespace tetmarch::testing
