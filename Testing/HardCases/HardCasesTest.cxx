// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What every case promises: a name, the same grid each time, a box that is really filled.
#include "HardCase.h"

#include "Grids.h"
#include "Input/GridVersions.h"
#include "RayChords.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <set>

namespace
{
using namespace tetmarch::testing;

TEST(HardCases, NamesAreUniqueAndFitForFiles)
{
  const std::string allowed = "abcdefghijklmnopqrstuvwxyz0123456789-";
  const std::set<std::string> groups = { "rays", "cells", "scale", "optics", "non-convex" };
  std::set<std::string> names;
  for (const HardCase& hard : hardCases())
  {
    SCOPED_TRACE(hard.Name);
    EXPECT_TRUE(names.insert(hard.Name).second) << "there are two of that name";
    EXPECT_FALSE(hard.Name.empty());
    EXPECT_EQ(hard.Name.find_first_not_of(allowed), std::string::npos);
    EXPECT_EQ(groups.count(hard.Group), 1u) << hard.Group;
    EXPECT_FALSE(hard.What.empty());
    EXPECT_EQ(findHardCase(hard.Name), &hard);
    std::set<std::string> views;
    for (const HardView& view : hard.Views)
    {
      EXPECT_TRUE(views.insert(view.Name).second) << "two views of the name " << view.Name;
      EXPECT_EQ(view.Name.find_first_not_of(allowed + "."), std::string::npos) << view.Name;
    }
  }
  EXPECT_EQ(findHardCase("no such case"), nullptr);
}

TEST(HardCases, SamePicturesHaveTheSameViews)
{
  const auto namesOf = [](const HardCase& hard)
  {
    std::vector<std::string> names;
    for (const HardView& view : hard.Views.empty() ? standardViews() : hard.Views)
    {
      names.push_back(view.Name);
    }
    return names;
  };
  int compared = 0;
  for (const HardCase& hard : hardCases())
  {
    if (!hard.SamePictureAs.empty())
    {
      SCOPED_TRACE(hard.Name);
      const HardCase* other = findHardCase(hard.SamePictureAs);
      ASSERT_NE(other, nullptr);
      EXPECT_NE(other, &hard);
      EXPECT_TRUE(other->SamePictureAs.empty()) << "itself a copy of " << other->SamePictureAs;
      EXPECT_EQ(namesOf(*other), namesOf(hard));
      ++compared;
    }
  }
  EXPECT_GE(compared, 15);
}

std::string bytesOf(vtkDataArray* array)
{
  const vtkIdType values = array->GetNumberOfValues();
  const vtkIdType bytes = array->GetDataType() == VTK_BIT
                            ? (values + 7) / 8
                            : values * static_cast<vtkIdType>(array->GetDataTypeSize());
  return std::string(static_cast<const char*>(array->GetVoidPointer(0)), bytes);
}

void expectSameBytes(vtkDataArray* a, vtkDataArray* b)
{
  ASSERT_NE(a, nullptr);
  ASSERT_NE(b, nullptr);
  EXPECT_EQ(a->GetDataType(), b->GetDataType());
  ASSERT_EQ(a->GetNumberOfTuples(), b->GetNumberOfTuples());
  EXPECT_TRUE(bytesOf(a) == bytesOf(b));
}

TEST(HardCases, MakeTheSameGridTwice)
{
  for (const HardCase& hard : hardCases())
  {
    SCOPED_TRACE(hard.Name);
    const Grid a = hard.Make();
    const Grid b = hard.Make();
    ASSERT_NE(a.Get(), b.Get());
    expectSameBytes(a->GetPoints()->GetData(), b->GetPoints()->GetData());
    expectSameBytes(a->GetCells()->GetConnectivityArray(), b->GetCells()->GetConnectivityArray());
    expectSameBytes(a->GetCells()->GetOffsetsArray(), b->GetCells()->GetOffsetsArray());
    expectSameBytes(tetmarch::cellTypesOf(a), tetmarch::cellTypesOf(b));
    expectSameBytes(a->GetPointData()->GetArray("f"), b->GetPointData()->GetArray("f"));
    expectSameBytes(a->GetCellData()->GetArray("c"), b->GetCellData()->GetArray("c"));
  }
}

TEST(HardCases, AreTetrahedraWithScalars)
{
  for (const HardCase& hard : hardCases())
  {
    SCOPED_TRACE(hard.Name);
    const Grid grid = hard.Make();
    EXPECT_GT(grid->GetNumberOfCells(), 0);
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
    {
      ASSERT_EQ(grid->GetCellType(cell), VTK_TETRA);
    }
    vtkDataArray* f = grid->GetPointData()->GetScalars();
    vtkDataArray* c = grid->GetCellData()->GetScalars();
    ASSERT_NE(f, nullptr);
    ASSERT_NE(c, nullptr);
    EXPECT_STREQ(f->GetName(), "f");
    EXPECT_STREQ(c->GetName(), "c");
    EXPECT_EQ(f->GetNumberOfTuples(), grid->GetNumberOfPoints());
    EXPECT_EQ(c->GetNumberOfTuples(), grid->GetNumberOfCells());
    if (hard.Group != "optics")
    {
      EXPECT_GT(f->GetRange()[1] - f->GetRange()[0], 0.1);
    }
  }
}

// A point in the box and a direction, in units of its edges.
Ray randomRay(const Box& box, std::mt19937& generator)
{
  Ray ray;
  for (int a = 0; a < 3; ++a)
  {
    const double edge = box.High[a] - box.Low[a];
    ray.Origin[a] = box.Low[a] + uniform(generator) * edge;
    ray.Direction[a] = (2.0 * uniform(generator) - 1.0) * edge;
  }
  return ray;
}

double lengthInBox(const Box& box, const Ray& ray)
{
  double t0 = -std::numeric_limits<double>::infinity();
  double t1 = -t0;
  for (int a = 0; a < 3; ++a)
  {
    const double low = (box.Low[a] - ray.Origin[a]) / ray.Direction[a];
    const double high = (box.High[a] - ray.Origin[a]) / ray.Direction[a];
    t0 = std::max(t0, std::min(low, high));
    t1 = std::min(t1, std::max(low, high));
  }
  return (t1 - t0) * std::hypot(ray.Direction[0], ray.Direction[1], ray.Direction[2]);
}

double lengthInCells(const RayChords& chords, const Ray& ray)
{
  double length = 0.0;
  for (const Chord& chord : RayChords::withoutOverlap(chords.find(ray)))
  {
    length += chord.T1 - chord.T0;
  }
  return length;
}

TEST(HardCases, BoxesAreFilled)
{
  int boxes = 0;
  for (const HardCase& hard : hardCases())
  {
    if (hard.Known != Answer::Box)
    {
      continue;
    }
    SCOPED_TRACE(hard.Name);
    ++boxes;
    const Box& box = hard.ExactBox;
    const Grid grid = hard.Make();
    for (int a = 0; a < 3; ++a)
    {
      EXPECT_EQ(grid->GetBounds()[2 * a], box.Low[a]);
      EXPECT_EQ(grid->GetBounds()[2 * a + 1], box.High[a]);
    }
    const RayChords chords(grid);
    std::mt19937 generator(5);
    for (int i = 0; i < 100; ++i)
    {
      const Ray ray = randomRay(box, generator);
      const double expected = lengthInBox(box, ray);
      ASSERT_NEAR(lengthInCells(chords, ray), expected, 1e-9 * expected) << "ray " << i;
    }
  }
  EXPECT_GE(boxes, 30);
}

TEST(HardCases, ViewsPlaceTheCamera)
{
  for (const HardCase& hard : hardCases())
  {
    const Grid grid = hard.Make();
    for (const HardView& view : hard.Views.empty() ? standardViews() : hard.Views)
    {
      SCOPED_TRACE(hard.Name + ", " + view.Name);
      vtkNew<vtkCamera> camera;
      view.Set(camera, grid);
      const double* direction = camera->GetDirectionOfProjection();
      const double* up = camera->GetViewUp();
      EXPECT_NEAR(std::hypot(direction[0], direction[1], direction[2]), 1.0, 1e-12);
      const double along = direction[0] * up[0] + direction[1] * up[1] + direction[2] * up[2];
      EXPECT_LT(std::abs(along), 0.9 * std::hypot(up[0], up[1], up[2]));
      EXPECT_TRUE(std::isfinite(camera->GetParallelScale()) && camera->GetParallelScale() > 0.0);
    }
  }
}

TEST(HardCases, OpticsAreSet)
{
  for (const HardCase& hard : hardCases())
  {
    SCOPED_TRACE(hard.Name);
    vtkNew<vtkVolumeProperty> property;
    const Grid grid = hard.Make();
    (hard.SetOptics ? hard.SetOptics : setStandardOptics)(property, grid);
    EXPECT_TRUE(std::isfinite(property->GetScalarOpacityUnitDistance()));
    EXPECT_GT(property->GetScalarOpacityUnitDistance(), 0.0);
    if (!hard.SetOptics)
    {
      double range[2];
      property->GetScalarOpacity()->GetRange(range);
      EXPECT_LT(range[0], range[1]);
      std::vector<double> opacities(1001);
      property->GetScalarOpacity()->GetTable(range[0], range[1], 1001, opacities.data());
      double mean = 0.0;
      for (const double opacity : opacities)
      {
        mean += opacity / 1001.0;
      }
      EXPECT_NEAR(mean * grid->GetLength() / property->GetScalarOpacityUnitDistance(), 3.0, 0.2);
    }
  }
}
} // namespace
