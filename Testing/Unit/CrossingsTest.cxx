// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Lengths before the pixels of a small picture, against volumes and lengths that are known.
#include "FirstPicture/Crossings.h"

#include "CellTypeGrids.h"
#include "QuadraticGrids.h"
#include "SmallGrids.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

const PicturePlane Front{ { { 1, 0, 0 } }, { { 0, 0, 1 } }, { { 0, -1, 0 } } };

DrawnArray firstArrayOf(vtkDataSet* data)
{
  DrawnArray drawn;
  drawn.Array = data->GetPointData()->GetArray(0);
  return drawn;
}

Crossings crossingsOf(vtkDataSet* data, const PicturePlane& plane = Front)
{
  return findCrossings({ data }, firstArrayOf(data), outlinePoints({ data }), plane);
}

double sum(const std::vector<double>& numbers)
{
  return std::accumulate(numbers.begin(), numbers.end(), 0.0);
}

// The picture's longer side is 96 pixels of the data's.
double volumeBefore(const Crossings& crossings, double longerSide)
{
  const double pixel = longerSide / 96;
  return sum(crossings.lengths()) * pixel * pixel;
}

vtkSmartPointer<vtkImageData> cube(int points)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(points, points, points);
  image->SetSpacing(1.0 / (points - 1), 1.0 / (points - 1), 1.0 / (points - 1));
  vtkNew<vtkDoubleArray> x;
  x->SetName("x");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    x->InsertNextValue(image->GetPoint(i)[0]);
  }
  image->GetPointData()->AddArray(x);
  return image;
}
} // namespace

TEST(Crossings, CellsOfEveryKindHaveTheirVolume)
{
  const auto expectUnit = [](const Grid& grid, const char* name)
  { EXPECT_NEAR(volumeBefore(crossingsOf(grid), 1), 1, 1e-5) << name; };
  expectUnit(hexLattice(3), "hexahedra");
  expectUnit(voxelLattice(3), "voxels");
  expectUnit(wedgeLattice(3), "wedges");
  expectUnit(pyramidLattice(3), "pyramids");
  expectUnit(polyhedronLattice(3), "polyhedra");
  expectUnit(mixedCells(3), "mixed");
  expectUnit(quadraticTetLattice(2), "quadratic tetrahedra");
  expectUnit(quadraticHexLattice(2), "quadratic hexahedra");
}

TEST(Crossings, RaysThroughACubeAreAsLongAsItsSide)
{
  const Crossings crossings = crossingsOf(hexLattice(8));
  ASSERT_EQ(crossings.Width, 96);
  ASSERT_EQ(crossings.Height, 96);
  const std::vector<double> lengths = crossings.lengths();
  double square = 0;
  for (const double length : lengths)
  {
    square += (length - 1) * (length - 1);
  }
  EXPECT_NEAR(sum(lengths) / double(lengths.size()), 1, 1e-5);
  EXPECT_LT(std::sqrt(square / double(lengths.size())), 0.35); // 4 points of a pixel in each cell
}

// 127^3 cells, of which one in 16 stands for all.
TEST(Crossings, AFewCellsStandForAll)
{
  const auto image = cube(128);
  const Crossings crossings = crossingsOf(image);
  EXPECT_LT(crossings.List.size(), std::size_t(2e6));
  EXPECT_NEAR(volumeBefore(crossings, 1), 1, 1e-4);
  const auto depths = crossings.opticalDepths([](double x) { return x; });
  EXPECT_NEAR(sum(depths) / double(depths.size()), 0.5, 5e-3); // the mean of x
}

TEST(Crossings, AreTheSameEachTime)
{
  const Grid grid = mixedCells(4);
  EXPECT_EQ(crossingsOf(grid).lengths(), crossingsOf(grid).lengths());
}

TEST(Crossings, WhatIsHiddenOrNotFiniteHasNone)
{
  const auto image = cube(3);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName("vtkGhostType");
  ghosts->SetNumberOfValues(8);
  ghosts->Fill(0);
  ghosts->SetValue(0, vtkDataSetAttributes::HIDDENCELL);
  ghosts->SetValue(1, vtkDataSetAttributes::DUPLICATECELL);
  image->GetCellData()->AddArray(ghosts);
  EXPECT_NEAR(volumeBefore(crossingsOf(image), 1), 0.75, 1e-5);
  image->GetCellData()->RemoveArray("vtkGhostType");
  image->GetPointData()->GetArray(0)->SetComponent(26, 0, std::nan("")); // a corner of one cell
  const double left = volumeBefore(crossingsOf(image), 1);
  EXPECT_LT(left, 1);
  EXPECT_GE(left, 0.875 - 1e-5);
}

TEST(Crossings, OfNothingThereAreNone)
{
  const Grid flat = triangleAndLineGrid();
  EXPECT_TRUE(crossingsOf(flat).List.empty());
  EXPECT_EQ(crossingsOf(singleTet()).lengths().size() > 0, true);
}

// The least and the largest that have a volume in double precision.
TEST(Crossings, CubesOfAnySizeHaveTheirVolume)
{
  for (const double size : { 1e-100, 1e-45, 1e45, 1e100 })
  {
    SCOPED_TRACE(size);
    const auto image = cube(9);
    image->SetSpacing(0.125 * size, 0.125 * size, 0.125 * size);
    const Crossings crossings = crossingsOf(image);
    EXPECT_EQ(crossings.Width, 96);
    EXPECT_NEAR(sum(crossings.lengths()) / size / (96 * 96), 1, 1e-5);
  }
}

TEST(Crossings, WhatIsNoPlaceIsInSomePixel)
{
  const double inf = std::numeric_limits<double>::infinity();
  for (const double size : { inf, std::nan(""), 1e200, 1e-200 })
  {
    SCOPED_TRACE(size);
    const auto image = cube(3);
    image->SetSpacing(size, 1, -size);
    const Crossings crossings = crossingsOf(image);
    EXPECT_EQ(crossings.lengths().size(), std::size_t(crossings.Width) * crossings.Height);
  }
}

TEST(Crossings, ConvexPointSetsAreCutAtTheirOwnPoints)
{
  const Grid grid = singleTet();
  const double before = sum(crossingsOf(grid).lengths());
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 5; ++i)
  {
    points->InsertNextPoint(7, 7, 7); // the cell's points are not the first of the grid
  }
  vtkIdType ids[4];
  for (int i = 0; i < 4; ++i)
  {
    ids[i] = points->InsertNextPoint(grid->GetPoint(i));
  }
  auto set = Grid::New();
  set->SetPoints(points);
  set->InsertNextCell(VTK_CONVEX_POINT_SET, 4, ids);
  vtkNew<vtkDoubleArray> array;
  array->SetName("f");
  array->SetNumberOfValues(9);
  array->Fill(1);
  set->GetPointData()->AddArray(array);
  EXPECT_NEAR(sum(crossingsOf(set).lengths()), before, 1e-5 * before);
}
