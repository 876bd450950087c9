// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FirstPicture/CameraFit.h"
#include "FirstPicture/ShownPart.h"

#include "LatticeGrids.h"
#include "SmallGrids.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

std::vector<Vector3> box(double x, double y, double z)
{
  std::vector<Vector3> points;
  for (int i = 0; i < 8; ++i)
  {
    points.push_back({ { x * (i & 1), y * (i >> 1 & 1), z * (i >> 2 & 1) } });
  }
  return points;
}

// Returns the extent of the visible part along x. The image is opaque from value 120 to value 130
// along x, except where it has NaN.
std::array<double, 2> shownAlongX(vtkImageData* image, bool ofCells)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName("values");
  const vtkIdType count = ofCells ? image->GetNumberOfCells() : image->GetNumberOfPoints();
  const vtkIdType row = image->GetDimensions()[0] - (ofCells ? 1 : 0);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const bool isOpaque = i % row >= 120 && i % row <= 130;
    values->InsertNextValue(i % row == 20 ? std::numeric_limits<double>::quiet_NaN()
                            : isOpaque    ? 1
                                          : 0.001);
  }
  vtkDataSetAttributes* attributes = image->GetPointData();
  if (ofCells)
  {
    attributes = image->GetCellData();
  }
  attributes->AddArray(values);
  DrawnArray drawn;
  drawn.Array = values;
  drawn.OfCells = ofCells;
  std::array<double, 2> extent{ { 1e9, -1e9 } };
  for (const Vector3& point : findShownCorners({ image }, drawn, [](double x) { return x; }))
  {
    extent = { { std::min(extent[0], point[0]), std::max(extent[1], point[0]) } };
  }
  return extent;
}

struct Reach
{
  double Across = 0; // farthest from the middle of the picture, whose side is at 1
  double Upwards = 0;
};

Reach reachIn(vtkCamera* camera, const std::vector<Vector3>& points, double aspect)
{
  camera->SetClippingRange(1e-3, 1e6);
  vtkMatrix4x4* matrix = camera->GetCompositeProjectionTransformMatrix(aspect, -1, 1);
  Reach reach;
  for (const Vector3& point : points)
  {
    double place[4] = { point[0], point[1], point[2], 1 };
    matrix->MultiplyPoint(place, place);
    reach.Across = std::max(reach.Across, std::abs(place[0] / place[3]));
    reach.Upwards = std::max(reach.Upwards, std::abs(place[1] / place[3]));
  }
  return reach;
}
} // namespace

TEST(CameraFit, TheSilhouetteFillsThePicture)
{
  for (const double aspect : { 0.5, 1.0, 16.0 / 9.0, 4.0 })
  {
    for (const auto& points : { box(1, 1, 1), box(10, 1, 2), box(1, 1, 8), box(3, 2, 0.01) })
    {
      vtkNew<vtkCamera> camera;
      fitCamera(points, choosePlane(points), aspect, camera);
      const Reach perspective = reachIn(camera, points, aspect);
      EXPECT_NEAR(std::max(perspective.Across, perspective.Upwards), 1 / 1.05, 1e-6);
      camera->ParallelProjectionOn();
      const Reach parallel = reachIn(camera, points, aspect);
      EXPECT_NEAR(std::max(parallel.Across, parallel.Upwards), 1 / 1.05, 1e-6);
    }
  }
}

// A tetrahedron leaves most of its box empty: its own corners touch the margin on both sides.
TEST(CameraFit, TheBoxDoesNotCount)
{
  const Grid grid = singleTet();
  const auto points = outlinePoints({ grid });
  ASSERT_EQ(points.size(), 4u);
  vtkNew<vtkCamera> camera;
  fitCamera(points, choosePlane(points), 1, camera);
  const Reach reach = reachIn(camera, points, 1);
  EXPECT_NEAR(std::max(reach.Across, reach.Upwards), 1 / 1.05, 1e-6);
}

TEST(CameraFit, WhatIsFlatIsSeenFromItsBroadSide)
{
  EXPECT_GT(std::abs(choosePlane(box(4, 3, 0.1)).Back[2]), 0.95);
  EXPECT_GT(choosePlane(box(4, 3, 0.1)).Back[2], 0);     // from above
  EXPECT_LT(choosePlane(box(4, 0.1, 3)).Back[1], -0.95); // from the front
  EXPECT_GT(std::abs(choosePlane(box(0.1, 3, 4)).Back[0]), 0.95);
  EXPECT_LT(std::abs(choosePlane(box(4, 3, 2)).Back[2]), 0.5);
  // A plate that is flat along no axis.
  std::vector<Vector3> tilted = box(4, 3, 0.05);
  for (Vector3& point : tilted)
  {
    point = { { point[0], 0.6 * point[1] - 0.8 * point[2], 0.8 * point[1] + 0.6 * point[2] } };
  }
  const Vector3 normal{ { 0, -0.8, 0.6 } };
  EXPECT_GT(std::abs(dot(choosePlane(tilted).Back, normal)), 0.95);
}

TEST(CameraFit, AxesArePerpendicular)
{
  for (const auto& points : { box(1, 1, 1), box(4, 3, 0.1), box(4, 0.1, 3), box(0.1, 3, 4) })
  {
    const PicturePlane plane = choosePlane(points);
    EXPECT_NEAR(dot(plane.Right, plane.Up), 0, 1e-12);
    EXPECT_NEAR(dot(plane.Right, plane.Back), 0, 1e-12);
    EXPECT_NEAR(dot(plane.Back, plane.Back), 1, 1e-12);
    EXPECT_NEAR(dot(plane.Up, plane.Up), 1, 1e-12);
  }
}

TEST(CameraFit, NothingAndAPointHaveACamera)
{
  vtkNew<vtkCamera> camera;
  for (const std::vector<Vector3>& points :
    { std::vector<Vector3>(), std::vector<Vector3>{ { { 1e6, 2, 3 } } } })
  {
    fitCamera(points, choosePlane(points), 1, camera);
    EXPECT_GT(camera->GetDistance(), 0);
    EXPECT_LT(camera->GetDistance(), 1e5);
    EXPECT_GT(camera->GetParallelScale(), 0);
  }
}

// A vtkCamera moves a near plane below 1e-20 to there.
TEST(CameraFit, WhatIsTooSmallIsNearerThanAnyNearPlane)
{
  vtkNew<vtkCamera> camera;
  for (const double size : { 1e-30, 1e-22, 2e-21, 1e-19, 1.0, 1e30 })
  {
    std::vector<Vector3> points;
    for (int i = 0; i < 8; ++i)
    {
      points.push_back({ { size * (i & 1), size * (i >> 1 & 1), size * (i >> 2) } });
    }
    fitCamera(points, choosePlane(points), 1, camera);
    EXPECT_EQ(isTooNear(points, camera), size < 1e-20) << size;
  }
  EXPECT_FALSE(isTooNear({}, camera));
}

TEST(CameraFit, PointsOfFlatCellsDoNotCount)
{
  const Grid grid = mixedDimensions(2);
  const vtkIdType far = grid->GetPoints()->InsertNextPoint(100, 0, 0);
  grid->GetPoints()->InsertNextPoint(0, 100, 0); // of no cell
  grid->InsertNextCell(VTK_VERTEX, 1, &far);
  EXPECT_EQ(outlinePoints({ grid }).size(), 27u);
}

TEST(CameraFit, OfImagesTheCorners)
{
  vtkNew<vtkImageData> image;
  image->SetExtent(2, 5, 0, 3, -1, 1);
  image->SetSpacing(2, 1, -1);
  const auto points = outlinePoints({ image });
  ASSERT_EQ(points.size(), 8u);
  EXPECT_EQ(points[0], (Vector3{ { 4, 0, 1 } }));
  EXPECT_EQ(points[7], (Vector3{ { 10, 3, -1 } }));
}

// Every third value is examined, or more. The corners contain the visible part, and exceed it by at
// most three cells at each end.
TEST(CameraFit, TheCornersContainTheVisiblePartOfImages)
{
  for (const bool ofCells : { false, true })
  {
    for (const int points : { 140, 250, 290 })
    {
      SCOPED_TRACE(ofCells ? points : -points);
      vtkNew<vtkImageData> image;
      image->SetDimensions(points, 4, 3);
      const auto shown = shownAlongX(image, ofCells);
      const double low = ofCells ? 120 : 119;
      EXPECT_LE(shown[0], low);
      EXPECT_GE(shown[0], low - 3);
      EXPECT_GE(shown[1], 131);
      EXPECT_LE(shown[1], 134);
    }
  }
}

TEST(CameraFit, HiddenCellsAreNotVisible)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(140, 3, 3);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(image->GetNumberOfCells());
  for (vtkIdType i = 0; i < ghosts->GetNumberOfValues(); ++i)
  {
    ghosts->SetValue(i, i % 139 < 124 ? vtkDataSetAttributes::HIDDENCELL : 0);
  }
  image->GetCellData()->AddArray(ghosts);
  EXPECT_EQ(shownAlongX(image, true), (std::array<double, 2>{ { 124, 132 } }));
  ghosts->Fill(vtkDataSetAttributes::HIDDENCELL);
  EXPECT_EQ(shownAlongX(image, true), (std::array<double, 2>{ { 1e9, -1e9 } }));
}
