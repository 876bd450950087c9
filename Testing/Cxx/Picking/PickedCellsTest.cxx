// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which cells are picked: those of the input in which the picked points lie, and those whose places
// the closed form says.
#include "EvenPick.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch::testing;

// The picked cell of the input has the point in it, and the picked scalar is that of the point.
void expectCells(vtkUnstructuredGrid* grid, const char* what, bool cellScalars)
{
  PickScene scene(grid);
  scene.property()->SetScalarOpacityUnitDistance(0.1);
  if (cellScalars)
  {
    scene.drawCellScalars();
  }
  vtkDataArray* ofPoints = grid->GetPointData()->GetScalars();
  vtkDataArray* ofCells = grid->GetCellData()->GetArray("c");
  std::set<vtkIdType> cells;
  double worst = 0.0;
  double worstScalar = 0.0;
  for (int y = 3; y < SceneSize; y += 9)
  {
    for (int x = 4; x < SceneSize; x += 11)
    {
      if (!scene.pick(x, y))
      {
        continue;
      }
      const vtkIdType id = scene.Mapper->GetPickedCellId();
      ASSERT_GE(id, 0);
      ASSERT_LT(id, grid->GetNumberOfCells());
      cells.insert(id);
      const Vec3 p = scene.pickedPosition();
      double closest[3];
      double local[3];
      double squared = 0.0;
      int part = 0;
      double weights[64];
      const int inside =
        grid->GetCell(id)->EvaluatePosition(p.data(), closest, part, local, squared, weights);
      ASSERT_GE(inside, 0);
      worst = std::max(worst, inside ? 0.0 : std::sqrt(squared));
      double expected = cellScalars ? ofCells->GetTuple1(id) : 0.0;
      for (vtkIdType i = 0; !cellScalars && i < grid->GetCell(id)->GetNumberOfPoints(); ++i)
      {
        expected += weights[i] * ofPoints->GetTuple1(grid->GetCell(id)->GetPointId(i));
      }
      worstScalar = std::max(worstScalar, std::abs(scene.Mapper->GetPickedScalar() - expected));
    }
  }
  EXPECT_GT(cells.size(), 8u) << what;
  EXPECT_LE(worst, 2e-6) << what;
  EXPECT_LE(worstScalar, 2e-6) << what;
  std::cout << "[ MEASURED ] " << what << ": " << cells.size() << " cells, points out of them by "
            << worst << ", scalars within " << worstScalar << '\n';
}

TEST(Picking, PointsLieInTheirCells)
{
  for (const bool cellScalars : { false, true })
  {
    expectCells(jitteredLattice(5), "tetrahedra", cellScalars);
    expectCells(hexLattice(5), "hexahedra", cellScalars);
    expectCells(wedgeLattice(4), "wedges", cellScalars);
    expectCells(mixedCells(4), "mixed cells", cellScalars);
    expectCells(latticeWithHole(6), "with a hole", cellScalars);
    expectCells(withJumps(jitteredLattice(5), 0.2), "with jumps", cellScalars);
  }
}

// The cells that a selector finds in an area are those of the closed form, since voxels are known
// by their places.
TEST(Picking, SelectorFindsTheCells)
{
  constexpr int n = 4;
  auto scene = evenScene(voxelLattice(n));
  for (const auto& area : { std::array<unsigned int, 4>{ { 60, 70, 75, 82 } },
         std::array<unsigned int, 4>{ { 0, 0, SceneSize - 1, SceneSize - 1 } } })
  {
    std::set<vtkIdType> sure;
    std::set<vtkIdType> possible;
    for (unsigned int y = area[1]; y <= area[3]; ++y)
    {
      for (unsigned int x = area[0]; x <= area[2]; ++x)
      {
        const ExpectedPick expected = expectedOn(scene->lineOf(int(x), int(y)), 0.5);
        if (expected.Kind == ExpectedPick::Missed)
        {
          continue;
        }
        // The cells in which the point may lie after rounding.
        std::set<vtkIdType> here;
        for (int corner = 0; corner < 8; ++corner)
        {
          vtkIdType id = 0;
          for (int a = 2; a >= 0; --a)
          {
            const double moved = expected.Position[a] + (corner >> a & 1 ? 1e-4 : -1e-4);
            id = n * id + std::clamp(int(std::floor(n * moved)), 0, n - 1);
          }
          here.insert(id);
        }
        possible.insert(here.begin(), here.end());
        if (here.size() == 1 && expected.Kind == ExpectedPick::Hit)
        {
          sure.insert(*here.begin());
        }
      }
    }
    const Selected found = scene->select(area[0], area[1], area[2], area[3]);
    ASSERT_EQ(found.size(), 1u);
    ASSERT_EQ(found.begin()->first, scene->Volume.Get());
    const std::set<vtkIdType>& cells = found.begin()->second;
    EXPECT_TRUE(std::includes(cells.begin(), cells.end(), sure.begin(), sure.end()));
    EXPECT_TRUE(std::includes(possible.begin(), possible.end(), cells.begin(), cells.end()));
    EXPECT_GE(sure.size(), 2u);
    std::cout << "[ MEASURED ] " << cells.size() << " cells, " << sure.size() << " of them sure, "
              << possible.size() << " possible\n";
  }
}
} // namespace
