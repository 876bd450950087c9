// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellTypeGrids.h"

#include "CubeLattice.h"
#include "CubeTopology.h"

#include "vtkCellType.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>

namespace tetmarch::testing
{
Grid hexLattice(int n, double warp, const Field& field)
{
  CubeLattice lattice(n, warp);
  lattice.forEachCube(
    [&](const Ids& cube) { lattice.Builder.addCell(VTK_HEXAHEDRON, pick(cube, HexCorners)); });
  return lattice.Builder.finish(field);
}

Grid voxelLattice(int n, const Field& field)
{
  CubeLattice lattice(n, 0.0);
  lattice.forEachCube([&](const Ids& cube) { lattice.Builder.addCell(VTK_VOXEL, cube); });
  return lattice.Builder.finish(field);
}

Grid wedgeLattice(int n, double warp, const Field& field)
{
  CubeLattice lattice(n, warp);
  lattice.forEachCube(
    [&](const Ids& cube)
    {
      for (const auto& wedge : CubeWedges)
      {
        lattice.Builder.addCell(VTK_WEDGE, pick(cube, wedge));
      }
    });
  return lattice.Builder.finish(field);
}

Grid pyramidLattice(int n, double warp, const Field& field)
{
  CubeLattice lattice(n, warp);
  lattice.forEachCube(
    [&](const Ids& cube)
    {
      const vtkIdType tip = lattice.Builder.between(cube);
      for (const auto& face : CubeFaces)
      {
        const Ids base = pick(cube, face);
        lattice.Builder.addCell(VTK_PYRAMID, { base[0], base[3], base[2], base[1], tip });
      }
    });
  return lattice.Builder.finish(field);
}

Grid polyhedronLattice(int n, double warp, const Field& field)
{
  CubeLattice lattice(n, warp);
  lattice.forEachCube(
    [&](const Ids& cube)
    {
      std::vector<Ids> faces;
      for (const auto& face : CubeFaces)
      {
        faces.push_back(pick(cube, face));
      }
      lattice.Builder.addPolyhedron(faces);
    });
  return lattice.Builder.finish(field);
}

Grid splitFacePolyhedron(const Field& field)
{
  GridBuilder builder({ 1.0, 0.5, 0.5 });
  std::vector<Ids> faces;
  const auto addFace = [&](const std::vector<std::array<int, 3>>& corners)
  {
    Ids face;
    for (const auto& c : corners)
    {
      face.push_back(builder.at(c[0], c[1], c[2]));
    }
    faces.push_back(face);
  };
  addFace({ { 0, 0, 0 }, { 0, 0, 2 }, { 0, 2, 2 }, { 0, 2, 0 } });
  addFace({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0, 1 }, { 1, 0, 2 }, { 0, 0, 2 } });
  addFace({ { 0, 2, 0 }, { 0, 2, 2 }, { 1, 2, 2 }, { 1, 2, 1 }, { 1, 2, 0 } });
  addFace({ { 0, 0, 0 }, { 0, 2, 0 }, { 1, 2, 0 }, { 1, 1, 0 }, { 1, 0, 0 } });
  addFace({ { 0, 0, 2 }, { 1, 0, 2 }, { 1, 1, 2 }, { 1, 2, 2 }, { 0, 2, 2 } });
  for (int j = 0; j < 2; ++j)
  {
    for (int k = 0; k < 2; ++k)
    {
      addFace({ { 1, j, k }, { 1, j + 1, k }, { 1, j + 1, k + 1 }, { 1, j, k + 1 } });
    }
  }
  builder.addPolyhedron(faces);
  for (int j = 0; j < 2; ++j)
  {
    for (int k = 0; k < 2; ++k)
    {
      builder.addCell(
        VTK_HEXAHEDRON, { builder.at(1, j, k), builder.at(2, j, k), builder.at(2, j + 1, k),
                          builder.at(1, j + 1, k), builder.at(1, j, k + 1), builder.at(2, j, k + 1),
                          builder.at(2, j + 1, k + 1), builder.at(1, j + 1, k + 1) });
    }
  }
  return builder.finish(field);
}

namespace
{
// In units of half a side along x and of half the height along y, a flat-topped hexagon about (0,
// 0) has its corners at (+-2, 0) and (+-1, +-1), and the hexagons' centres lie at (3 i, 2 j + i mod
// 2).
template <typename AddPrism>
Grid honeycomb(int n, const Field& field, AddPrism&& addPrism)
{
  const double side = 0.5 / n;
  GridBuilder builder({ 0.5 * side, 0.5 * std::sqrt(3.0) * side, 1.0 / n });
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        addPrism(
          [&, i, j, k](int type, const std::vector<std::array<int, 2>>& polygon)
          {
            Ids points;
            for (const int layer : { k, k + 1 })
            {
              for (const auto& corner : polygon)
              {
                points.push_back(builder.at(3 * i + corner[0], 2 * j + i % 2 + corner[1], layer));
              }
            }
            builder.addCell(type, points);
          });
      }
    }
  }
  return builder.finish(field);
}
} // namespace

Grid hexagonalPrismLattice(int n, const Field& field)
{
  return honeycomb(n, field,
    [](auto&& add) {
      add(VTK_HEXAGONAL_PRISM, { { 2, 0 }, { 1, 1 }, { -1, 1 }, { -2, 0 }, { -1, -1 }, { 1, -1 } });
    });
}

Grid pentagonalPrismLattice(int n, const Field& field)
{
  // The line meets the two sides that a hexagon shares with those above and below it, which are cut
  // there too.
  return honeycomb(n, field,
    [](auto&& add)
    {
      add(VTK_PENTAGONAL_PRISM, { { 2, 0 }, { 1, 1 }, { 0, 1 }, { 0, -1 }, { 1, -1 } });
      add(VTK_PENTAGONAL_PRISM, { { -2, 0 }, { -1, -1 }, { 0, -1 }, { 0, 1 }, { -1, 1 } });
    });
}

double honeycombVolume(int n)
{
  const double side = 0.5 / n;
  return n * n * 1.5 * std::sqrt(3.0) * side * side;
}
} // namespace tetmarch::testing
