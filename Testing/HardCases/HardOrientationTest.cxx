// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which cells of the meshes share faces, and whether all of them can be turned the same way.
#include "CaseAccess.h"

#include "GridSummary.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <vector>

namespace
{
using namespace tetmarch::testing;

// The sign of the permutation that sorts the points.
int parity(const Ids& points)
{
  int sign = 1;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (std::size_t j = i + 1; j < points.size(); ++j)
    {
      sign = points[i] > points[j] ? -sign : sign;
    }
  }
  return sign;
}

struct HalfFace
{
  vtkIdType Cell;
  int Sign; // 1 if the cell's order of points turns the face as its sorted points do, or else -1
};

// Faces by their sorted points.
std::map<Ids, std::vector<HalfFace>> facesWithOwners(vtkUnstructuredGrid* grid)
{
  std::map<Ids, std::vector<HalfFace>> faces;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const Ids points = cellOf(grid, cell);
    for (int i = 0; i < 4; ++i)
    {
      Ids face = points;
      face.erase(face.begin() + i);
      const int sign = (i % 2 == 0 ? 1 : -1) * parity(face);
      std::sort(face.begin(), face.end());
      faces[face].push_back({ cell, sign });
    }
  }
  return faces;
}

// Can every cell be given a sign so that neighbours induce opposite orientations on the faces
// between them? By connectivity alone: positions and the order of points in cells don't matter.
bool isOrientable(vtkUnstructuredGrid* grid)
{
  struct Neighbour
  {
    vtkIdType Cell;
    int Relation;
  };
  std::vector<std::vector<Neighbour>> neighbours(grid->GetNumberOfCells());
  for (const auto& [face, owners] : facesWithOwners(grid))
  {
    if (owners.size() == 2)
    {
      const int relation = -owners[0].Sign * owners[1].Sign;
      neighbours[owners[0].Cell].push_back({ owners[1].Cell, relation });
      neighbours[owners[1].Cell].push_back({ owners[0].Cell, relation });
    }
  }
  std::vector<int> signs(neighbours.size(), 0);
  for (std::size_t start = 0; start < signs.size(); ++start)
  {
    if (signs[start] != 0)
    {
      continue;
    }
    signs[start] = 1;
    std::vector<vtkIdType> open = { static_cast<vtkIdType>(start) };
    while (!open.empty())
    {
      const vtkIdType cell = open.back();
      open.pop_back();
      for (const Neighbour& neighbour : neighbours[cell])
      {
        const int wanted = signs[cell] * neighbour.Relation;
        if (signs[neighbour.Cell] == 0)
        {
          signs[neighbour.Cell] = wanted;
          open.push_back(neighbour.Cell);
        }
        else if (signs[neighbour.Cell] != wanted)
        {
          return false;
        }
      }
    }
  }
  return true;
}

TEST(HardTopology, MoebiusRingIsNotOrientable)
{
  const Grid ring = gridOf("moebius");
  EXPECT_FALSE(isOrientable(ring));
  // Each tetrahedron has two neighbours: it is one ring.
  std::vector<int> neighbours(ring->GetNumberOfCells(), 0);
  for (const auto& [face, owners] : facesWithOwners(ring))
  {
    ASSERT_LE(owners.size(), 2u);
    for (const HalfFace& owner : owners)
    {
      neighbours[owner.Cell] += owners.size() == 2;
    }
  }
  EXPECT_EQ(std::count(neighbours.begin(), neighbours.end(), 2), ring->GetNumberOfCells());

  EXPECT_TRUE(isOrientable(gridOf("torus")));
  EXPECT_TRUE(isOrientable(gridOf("reversed-every-second")));
  EXPECT_TRUE(isOrientable(gridOf("tangled")));
  EXPECT_TRUE(isOrientable(gridOf("nested-shells")));
}

TEST(HardTopology, FacesOfThreeOwners)
{
  EXPECT_EQ(summarise(gridOf("face-of-three")).FacesOfMore, 1);
  const Grid lattice = gridOf("faces-of-three");
  EXPECT_EQ(summarise(lattice).FacesOfMore, 5 * 5 * 5);
  for (const auto& [face, owners] : facesWithOwners(lattice))
  {
    EXPECT_LE(owners.size(), 3u);
  }
}
} // namespace
