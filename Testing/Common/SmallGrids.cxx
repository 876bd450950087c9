// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SmallGrids.h"

#include "CubeLattice.h"
#include "CubeTopology.h"

#include "vtkCellType.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

namespace tetmarch::testing
{
namespace
{
Grid tets(const std::vector<Vec3>& points, const std::vector<Ids>& cells, const Field& field)
{
  GridBuilder builder;
  for (const Vec3& point : points)
  {
    builder.addPoint(point);
  }
  for (const Ids& cell : cells)
  {
    builder.addCell(VTK_TETRA, cell);
  }
  return builder.finish(field);
}

const std::vector<Vec3> UnitTet = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };

std::vector<Vec3> unitTetAnd(const std::vector<Vec3>& more)
{
  std::vector<Vec3> points = UnitTet;
  points.insert(points.end(), more.begin(), more.end());
  return points;
}
} // namespace

Grid singleTet(const Field& field) { return tets(UnitTet, { { 0, 1, 2, 3 } }, field); }

Grid twoTetsSharingFace(const Field& field)
{
  return tets(unitTetAnd({ { 1, 1, 1 } }), { { 0, 1, 2, 3 }, { 1, 2, 3, 4 } }, field);
}

Grid twoTetsSharingEdge(const Field& field)
{
  return tets(
    unitTetAnd({ { -1, 0, 0 }, { 0, -1, 0 } }), { { 0, 1, 2, 3 }, { 0, 4, 5, 3 } }, field);
}

Grid twoTetsSharingVertex(const Field& field)
{
  return tets(unitTetAnd({ { -1, 0, 0 }, { 0, -1, 0 }, { 0, 0, -1 } }),
    { { 0, 1, 2, 3 }, { 0, 5, 4, 6 } }, field);
}

Grid emptyGrid()
{
  auto grid = Grid::New();
  vtkNew<vtkPoints> points;
  grid->SetPoints(points);
  grid->Allocate();
  return grid;
}

Grid triangleAndLineGrid(const Field& field)
{
  GridBuilder builder;
  for (const Vec3& point : std::vector<Vec3>{ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } })
  {
    builder.addPoint(point);
  }
  builder.addCell(VTK_TRIANGLE, { 0, 1, 2 });
  builder.addCell(VTK_QUAD, { 0, 1, 2, 3 });
  builder.addCell(VTK_LINE, { 0, 3 });
  builder.addCell(VTK_VERTEX, { 2 });
  return builder.finish(field);
}

Grid mixedDimensions(int n, const Field& field)
{
  CubeLattice lattice(n, 0.0);
  GridBuilder& builder = lattice.Builder;
  lattice.forEachCube(
    [&](const Ids& cube)
    {
      for (const auto& tet : KuhnTets)
      {
        builder.addCell(VTK_TETRA, pick(cube, tet));
      }
    });
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const Ids cube = lattice.cube(i, j, 0);
      builder.addCell(VTK_TRIANGLE, { cube[0], cube[2], cube[3] });
      builder.addCell(VTK_TRIANGLE, { cube[0], cube[3], cube[1] });
    }
  }
  builder.addCell(VTK_LINE, { 0, 1 });
  builder.addCell(VTK_VERTEX, { 0 });
  return builder.finish(field);
}

Grid defectiveTets(const Field& field)
{
  return tets(unitTetAnd({ { 1, 1, 1 }, { 1, 1, 0 }, { -1, -1, -1 } }),
    { { 0, 1, 2, 3 }, { 1, 0, 3, 2 }, { 1, 2, 4, 4 }, { 0, 1, 5, 2 }, { 0, 1, 2, 6 } }, field);
}
} // namespace tetmarch::testing
