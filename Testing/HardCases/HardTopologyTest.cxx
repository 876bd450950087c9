// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Parts, boundaries and holes of the meshes, and how often a ray enters them.
#include "CaseAccess.h"

#include "GridSummary.h"
#include "Grids.h"
#include "RayChords.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <numeric>
#include <set>

namespace
{
using namespace tetmarch::testing;

TEST(HardTopology, HangingNodesMakeFacesOfOneOwnerInside)
{
  const Grid grid = gridOf("hanging-nodes");
  int inside = 0;
  for (const Ids& face : summarise(grid).Boundary)
  {
    inside += std::all_of(
      face.begin(), face.end(), [&](vtkIdType id) { return grid->GetPoint(id)[0] == 0.5; });
  }
  EXPECT_EQ(inside, 2 * 4 * 4 + 2 * 8 * 8);
  const Grid bulging = gridOf("hanging-nodes-bulging");
  int moved = 0;
  for (vtkIdType i = 0; i < bulging->GetNumberOfPoints(); ++i)
  {
    moved += std::abs(std::abs(bulging->GetPoint(i)[0] - 0.5) - 0.2 / 8.0) < 1e-12;
  }
  EXPECT_GT(moved, 30);
}

int componentsOf(vtkUnstructuredGrid* grid)
{
  Ids parent(static_cast<std::size_t>(grid->GetNumberOfPoints()));
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&parent](vtkIdType i)
  {
    while (parent[i] != i)
    {
      i = parent[i] = parent[parent[i]];
    }
    return i;
  };
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const Ids points = cellOf(grid, cell);
    for (const vtkIdType point : points)
    {
      parent[root(point)] = root(points[0]);
    }
  }
  int components = 0;
  for (std::size_t i = 0; i < parent.size(); ++i)
  {
    components += parent[i] == static_cast<vtkIdType>(i);
  }
  return components;
}

TEST(HardTopology, ComponentsShareNoPoints)
{
  for (const char* name : { "touching-in-face", "touching-in-edge", "touching-in-vertex",
         "overlapping", "one-in-another", "cubes-side-by-side", "two-equal-meshes" })
  {
    EXPECT_EQ(componentsOf(gridOf(name)), 2) << name;
  }
  EXPECT_EQ(componentsOf(gridOf("sheets")), 40);
  EXPECT_EQ(componentsOf(gridOf("torus")), 1);
  EXPECT_EQ(componentsOf(gridOf("comb")), 1);
}

// How many points of the second component lie exactly on one of the first.
int touchingPoints(vtkUnstructuredGrid* grid, vtkIdType firstPoints)
{
  std::set<Vec3> first;
  int count = 0;
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    Vec3 p;
    grid->GetPoint(i, p.data());
    if (i < firstPoints)
    {
      first.insert(p);
    }
    else
    {
      count += static_cast<int>(first.count(p));
    }
  }
  return count;
}

TEST(HardTopology, ComponentsTouch)
{
  EXPECT_EQ(touchingPoints(gridOf("touching-in-face"), 125), 25);
  EXPECT_EQ(touchingPoints(gridOf("touching-in-edge"), 125), 5);
  EXPECT_EQ(touchingPoints(gridOf("touching-in-vertex"), 125), 1);
}

// The Euler characteristic of the boundary, a closed surface: 0 for a torus, 2 for a ball.
int eulerCharacteristicOfBoundary(vtkUnstructuredGrid* grid)
{
  std::set<vtkIdType> points;
  std::map<Ids, int> edges;
  const GridSummary summary = summarise(grid);
  for (const Ids& face : summary.Boundary)
  {
    points.insert(face.begin(), face.end());
    for (int i = 0; i < 3; ++i)
    {
      Ids edge = { face[i], face[(i + 1) % 3] };
      std::sort(edge.begin(), edge.end());
      ++edges[edge];
    }
  }
  for (const auto& [edge, users] : edges)
  {
    EXPECT_EQ(users, 2);
  }
  return static_cast<int>(points.size()) - static_cast<int>(edges.size()) +
         static_cast<int>(summary.FacesOnBoundary);
}

TEST(HardTopology, ShapesOfBoundaries)
{
  EXPECT_EQ(eulerCharacteristicOfBoundary(gridOf("torus")), 0);
  EXPECT_EQ(eulerCharacteristicOfBoundary(gridOf("tunnel")), 0);
  EXPECT_EQ(eulerCharacteristicOfBoundary(gridOf("spiral")), 2);
  EXPECT_EQ(eulerCharacteristicOfBoundary(gridOf("cavity")), 4);
  for (const char* name : { "torus", "spiral", "comb", "sheets", "swiss-cheese" })
  {
    EXPECT_GT(summarise(gridOf(name)).LeastVolume, 0.0) << name;
  }
}

// Stretches of a ray inside cells with gaps of more than `least` between them.
int entries(vtkUnstructuredGrid* grid, const Ray& ray, double least)
{
  int count = 0;
  double end = -RayChords::Infinity;
  for (const Chord& chord : RayChords(grid).find(ray))
  {
    count += chord.T0 - end > least;
    end = std::max(end, chord.T1);
  }
  return count;
}

TEST(HardTopology, RaysEnterOften)
{
  EXPECT_EQ(entries(gridOf("comb"), { { -1.0, 0.06, 0.19 }, { 1.0, 0.0, 0.0 } }, 0.9e-3), 1000);
  EXPECT_EQ(entries(gridOf("sheets"), { { 0.3, 0.4, 2.0 }, { 0.0, 0.0, -1.0 } }, 0.9e-4), 40);
  EXPECT_EQ(entries(gridOf("spiral"), { { -3.0, 0.01, 0.1 }, { 1.0, 0.0, 0.0 } }, 0.01), 8);
  EXPECT_EQ(entries(gridOf("torus"), { { -3.0, 0.01, 0.1 }, { 1.0, 0.0, 0.0 } }, 0.01), 2);
  EXPECT_EQ(entries(gridOf("nested-shells"), { { 0.5, 0.48, -1.0 }, { 0.01, 0.0, 1.0 } }, 0.01), 3);
}

TEST(HardTopology, SwissCheeseHasALargeBoundary)
{
  const GridSummary summary = summarise(gridOf("swiss-cheese"));
  EXPECT_GE(summary.FacesOnBoundary, 100000);
  EXPECT_LE(summary.FacesOnBoundary, 130000);
  EXPECT_EQ(summary.FacesOfMore, 0);
}
} // namespace
