// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReentrantGrids.h"

#include "CubeLattice.h"
#include "CubeTopology.h"

#include "vtkCellType.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace tetmarch::testing
{
namespace
{
using PointAt = std::function<vtkIdType(int, int, int)>;

void addCube(GridBuilder& builder, const PointAt& at, int i, int j, int k)
{
  Ids corners;
  for (int b = 0; b < 8; ++b)
  {
    corners.push_back(at(i + (b & 1), j + ((b >> 1) & 1), k + (b >> 2)));
  }
  for (const auto& tet : KuhnTets)
  {
    builder.addCell(VTK_TETRA, pick(corners, tet));
  }
}

void addBar(GridBuilder& builder, const PointAt& at, int length, int across)
{
  for (int k = 0; k < across; ++k)
  {
    for (int j = 0; j < across; ++j)
    {
      for (int i = 0; i < length; ++i)
      {
        addCube(builder, at, i, j, k);
      }
    }
  }
}
} // namespace

Grid torus(int segments, int across, const Field& field)
{
  GridBuilder builder;
  const auto at = [&](int i, int j, int k)
  {
    const vtkIdType point = builder.at(i % segments, j, k);
    const double turn = -2.0 * vtkMath::Pi() * (i % segments) / segments;
    const double y = 2.0 * j / across - 1.0;
    const double z = 2.0 * k / across - 1.0;
    // Squares about the middle become circles.
    const double length = std::hypot(y, z);
    const double shrink = length > 0.0 ? std::max(std::abs(y), std::abs(z)) / length : 0.0;
    const double radius = 1.0 + 0.35 * shrink * y;
    builder.move(point, { radius * std::cos(turn), radius * std::sin(turn), 0.35 * shrink * z });
    return point;
  };
  addBar(builder, at, segments, across);
  return builder.finish(field);
}

Grid spiral(double turns, int segments, const Field& field)
{
  GridBuilder builder;
  const auto at = [&](int i, int j, int k)
  {
    const vtkIdType point = builder.at(i, j, k);
    const double turn = turns * i / segments;
    const double radius = 0.2 + 0.2 * turn + 0.04 * (j - 1);
    const double angle = -2.0 * vtkMath::Pi() * turn;
    builder.move(point, { radius * std::cos(angle), radius * std::sin(angle), 0.15 * k });
    return point;
  };
  addBar(builder, at, segments, 2);
  return builder.finish(field);
}

Grid comb(int teeth, const Field& field)
{
  GridBuilder builder({ 1e-3, 0.125, 0.125 });
  const auto at = [&](int i, int j, int k) { return builder.at(i, j, k); };
  for (int i = 0; i < 2 * teeth - 1; ++i)
  {
    addCube(builder, at, i, 0, 0);
    if (i % 2 == 0)
    {
      addCube(builder, at, i, 0, 1);
    }
  }
  return builder.finish(field);
}

Grid sheets(int count, int n, double gap, const Field& field)
{
  GridBuilder builder({ 1.0 / n, 1.0 / n, 1.0 });
  const double thickness = (1.0 - (count - 1) * gap) / count;
  for (int sheet = 0; sheet < count; ++sheet)
  {
    const auto at = [&](int i, int j, int k)
    {
      const vtkIdType point = builder.at(i, j, 2 * sheet + k);
      const Vec3 p = builder.position(point);
      builder.move(point, { p[0], p[1], sheet * (thickness + gap) + k * thickness });
      return point;
    };
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        addCube(builder, at, i, j, 0);
      }
    }
  }
  return builder.finish(field);
}
} // namespace tetmarch::testing
