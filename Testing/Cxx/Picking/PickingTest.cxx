// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What is picked: points against closed forms, cells against a search of their own.
#include "CpuReference.h"
#include "CutScene.h"
#include "CutWay.h"
#include "PickScene.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkTransform.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch::testing;

constexpr Vec3 Low{ 0.0, 0.0, 0.0 };
constexpr Vec3 High{ 1.0, 1.0, 1.0 };
constexpr double UnitDistance = Even::UnitDistance;
constexpr double Extinction = Even::Opacity / UnitDistance;

double distance(const Vec3& a, const Vec3& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// Of the threshold's point, from where the line comes into the cube or begins in it; false if it
// leaves the cube before, and an empty answer near to that.
struct Expected
{
  enum
  {
    Hit,
    Missed,
    Unsure
  } Kind;
  Vec3 Position;
};

Expected expectedOn(const PickScene::PixelLine& line, double threshold,
  double extinction = Extinction, const tetmarch::ClippingOptions& cut = {})
{
  const double ahead = boxChord(line.Near, line.Direction, Low, High, 0.0);
  // How far in front of it the cube begins.
  double begin = 0.0;
  for (int a = 0; a < 3; ++a)
  {
    const double t0 = (Low[a] - line.Near[a]) / line.Direction[a];
    const double t1 = (High[a] - line.Near[a]) / line.Direction[a];
    begin = std::max(begin, std::min(t0, t1));
  }
  const Vec3 first = line.at(begin), last = line.at(begin + ahead);
  double missing = -std::log1p(-threshold) / extinction;
  Expected expected{ Expected::Missed, first };
  for (const auto& part : partsLeft(cut, { first, first }, { last, last }))
  {
    const double length = ahead * (part[1] - part[0]);
    if (std::abs(length - missing) < 1e-3 || (missing > 0.0 && missing < 1e-6))
    {
      return { Expected::Unsure, first };
    }
    if (expected.Kind == Expected::Missed && length > missing)
    {
      expected = { Expected::Hit, line.at(begin + ahead * part[0] + missing) };
      break;
    }
    missing -= length;
  }
  return expected;
}

void expectClosedForm(PickScene& scene, double threshold, double tolerance, const char* what,
  double extinction = Extinction)
{
  scene.Mapper->SetPickOpacityThreshold(threshold);
  const int* size = scene.Renderer->GetSize();
  const int* origin = scene.Renderer->GetOrigin();
  int hits = 0;
  int misses = 0;
  double worst = 0.0;
  for (int y = 7; y < size[1]; y += 13)
  {
    for (int x = 5; x < size[0]; x += 13)
    {
      const int column = origin[0] + x;
      const int row = origin[1] + y;
      const Expected expected =
        expectedOn(scene.lineOf(column, row), threshold, extinction, clippingOf(scene.Mapper));
      if (expected.Kind == Expected::Unsure)
      {
        continue;
      }
      const bool hit = scene.pick(column, row);
      ASSERT_EQ(hit, expected.Kind == Expected::Hit) << column << ", " << row;
      hits += hit ? 1 : 0;
      misses += hit ? 0 : 1;
      if (hit)
      {
        worst = std::max(worst, distance(scene.pickedPosition(), expected.Position));
      }
      else
      {
        ASSERT_TRUE(std::isnan(scene.pickedPosition()[0]));
        ASSERT_TRUE(std::isnan(scene.Mapper->GetPickedScalar()));
        ASSERT_EQ(scene.Mapper->GetPickedCellId(), -1);
      }
    }
  }
  EXPECT_LE(worst, tolerance) << what;
  EXPECT_GT(hits, 10) << what;
  std::cout << "[ MEASURED ] " << what << ", threshold " << threshold << ": " << hits
            << " points within " << worst << ", " << misses << " misses\n";
}

// The rasteriser's rounding moves a pixel's ray a little.
constexpr double RayTolerance = 1e-5;

TEST(Picking, PointsOfEvenExtinction)
{
  auto scene = evenScene(hexLattice(4));
  for (const double threshold : { 0.1, 0.5, 0.9 })
  {
    expectClosedForm(*scene, threshold, RayTolerance, "perspective");
  }
  scene->camera()->ParallelProjectionOn();
  scene->camera()->SetParallelScale(0.9);
  scene->Window->Render();
  expectClosedForm(*scene, 0.5, RayTolerance, "parallel");
}

TEST(Picking, PointsOfEvenExtinctionInCells)
{
  auto scene = evenScene(mixedCells(4));
  scene->drawCellScalars();
  expectClosedForm(*scene, 0.5, RayTolerance, "cell scalars");
}

// Gradients that halve the extinction wherever they are.
TEST(Picking, PointsOfExtinctionByGradients)
{
  auto scene = evenScene(jitteredLattice(4));
  vtkNew<vtkPiecewiseFunction> half;
  half->AddPoint(0.0, 0.5);
  half->AddPoint(10.0, 0.5);
  scene->property()->SetGradientOpacity(half);
  for (const int type :
    { vtkTetMarchVolumeMapper::VERTEX_GRADIENTS, vtkTetMarchVolumeMapper::CELL_GRADIENTS })
  {
    scene->Mapper->SetGradientType(type);
    expectClosedForm(*scene, 0.5, RayTolerance, "gradient opacity", 0.5 * Extinction);
  }
}

// Only what is left gathers anything, and in each region alike.
TEST(Picking, WhatIsCutAwayIsNotHit)
{
  auto scene = evenScene(jitteredLattice(5));
  for (const int flags : { VTK_CROP_SUBVOLUME, VTK_CROP_FENCE, VTK_CROP_INVERTED_CROSS, 0x5555555 })
  {
    crop(*scene, flags);
    expectClosedForm(*scene, 0.15, RayTolerance, "cropped");
  }
  scene->drawCellScalars();
  clipObliquely(*scene);
  expectClosedForm(*scene, 0.3, RayTolerance, "cells, cropped and clipped");
}

// Nothing before the near plane is hit, and what lies there gathers nothing.
TEST(Picking, CameraInside)
{
  auto scene = evenScene(jitteredLattice(5));
  scene->camera()->SetPosition(0.4, 0.45, 0.95);
  scene->camera()->SetFocalPoint(0.55, 0.5, 0.0);
  scene->camera()->SetViewUp(0.0, 1.0, 0.0);
  scene->camera()->SetClippingRange(0.02, 3.0);
  scene->Window->Render();
  expectClosedForm(*scene, 0.5, RayTolerance, "inside");
}

TEST(Picking, AViewportBesideAnother)
{
  auto scene = evenScene(jitteredLattice(5));
  scene->Window->SetSize(2 * SceneSize, SceneSize);
  vtkNew<vtkRenderer> other;
  other->SetViewport(0.0, 0.0, 0.5, 1.0);
  scene->Window->AddRenderer(other);
  scene->Renderer->SetViewport(0.5, 0.1, 1.0, 0.9);
  scene->Window->Render();
  expectClosedForm(*scene, 0.5, RayTolerance, "viewport");
  // Beyond it, and beyond the window.
  EXPECT_FALSE(scene->pick(SceneSize / 2, SceneSize / 2));
  EXPECT_FALSE(scene->pick(-1, SceneSize / 2));
  EXPECT_FALSE(scene->pick(SceneSize, 3 * SceneSize));
}

// The threshold of 0 is where anything is seen at all, that of 1 where nothing else is.
TEST(Picking, ThresholdsAtTheEnds)
{
  auto scene = evenScene(hexLattice(4));
  expectClosedForm(*scene, 0.0, RayTolerance, "first point");
  scene->Mapper->SetPickOpacityThreshold(1.0);
  EXPECT_FALSE(scene->pick(SceneSize / 2, SceneSize / 2));
  scene->property()->SetScalarOpacityUnitDistance(0.02);
  ASSERT_TRUE(scene->pick(SceneSize / 2, SceneSize / 2));
  const auto line = scene->lineOf(SceneSize / 2, SceneSize / 2);
  const double begin = distance(expectedOn(line, 0.0).Position, line.Near);
  EXPECT_NEAR(distance(scene->pickedPosition(), line.Near) - begin,
    std::log(double(1 << 24)) * 0.02 / Even::Opacity, 1e-4);
}

// The cell of the input around the point, and the scalar there.
void expectCells(vtkUnstructuredGrid* grid, const char* what, bool cellScalars)
{
  PickScene scene(grid);
  scene.property()->SetScalarOpacityUnitDistance(0.1);
  if (cellScalars)
  {
    scene.drawCellScalars();
  }
  const Field field = linearField();
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
      const double expected = cellScalars ? ofCells->GetTuple1(id) : field(p[0], p[1], p[2]);
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
  }
}

// A selector's area against the closed form: voxels by their place.
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
        const Expected expected = expectedOn(scene->lineOf(int(x), int(y)), 0.5);
        if (expected.Kind == Expected::Missed)
        {
          continue;
        }
        // The cells to which rounding may move it.
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
        if (here.size() == 1 && expected.Kind == Expected::Hit)
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

// Scalars below 0.5 are transparent.
TEST(Picking, WhatIsTransparentIsNotHit)
{
  PickScene scene(jitteredLattice(6));
  vtkPiecewiseFunction* opacity = scene.property()->GetScalarOpacity();
  opacity->RemoveAllPoints();
  opacity->AddPoint(0.5, 0.0);
  opacity->AddPoint(0.51, 1.0);
  scene.property()->SetScalarOpacityUnitDistance(1e-3);
  const Field field = linearField();
  int hits = 0;
  for (int x = 10; x < SceneSize; x += 10)
  {
    if (scene.pick(x, SceneSize / 2))
    {
      const Vec3 p = scene.pickedPosition();
      EXPECT_GT(field(p[0], p[1], p[2]), 0.5);
      ++hits;
    }
  }
  EXPECT_GT(hits, 4);
  opacity->RemoveAllPoints();
  opacity->AddPoint(0.0, 0.0);
  EXPECT_TRUE(scene.selectAll().empty());
  EXPECT_FALSE(scene.pick(SceneSize / 2, SceneSize / 2));
}

// In the world, whatever the volume's place.
TEST(Picking, AMovedVolume)
{
  auto scene = evenScene(jitteredLattice(5));
  ASSERT_TRUE(scene->pick(70, 85));
  const Vec3 before = scene->pickedPosition();
  const vtkIdType cell = scene->Mapper->GetPickedCellId();
  vtkNew<vtkTransform> place;
  place->Translate(10.0, -5.0, 3.0);
  place->RotateWXYZ(40.0, 1.0, 2.0, 3.0);
  place->Scale(3.0, 3.0, 3.0);
  scene->Volume->SetUserTransform(place);
  scene->camera()->ApplyTransform(place);
  scene->camera()->SetClippingRange(1.0, 40.0);
  scene->property()->SetScalarOpacityUnitDistance(3.0 * UnitDistance);
  ASSERT_TRUE(scene->pick(70, 85));
  EXPECT_EQ(scene->Mapper->GetPickedCellId(), cell);
  Vec3 moved{};
  place->TransformPoint(before.data(), moved.data());
  EXPECT_LE(distance(scene->pickedPosition(), moved), 1e-4);
}

// The frame of before is neither needed nor asked.
TEST(Picking, WithoutAFrameAndWithOtherData)
{
  PickScene scene(jitteredLattice(5));
  ASSERT_TRUE(scene.pick(70, 85));
  const vtkIdType cell = scene.Mapper->GetPickedCellId();
  const Grid other = hexLattice(3);
  scene.Mapper->SetInputData(other);
  ASSERT_TRUE(scene.pick(70, 85));
  EXPECT_LT(scene.Mapper->GetPickedCellId(), other->GetNumberOfCells());
  scene.Mapper->SetInputData(scene.Data);
  ASSERT_TRUE(scene.pick(70, 85));
  EXPECT_EQ(scene.Mapper->GetPickedCellId(), cell);
}
} // namespace
