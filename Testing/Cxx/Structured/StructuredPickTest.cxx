// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What is picked in an image or a rectilinear grid, against the ground truth by brute force.
#include "StructuredScene.h"
#include "Unprojection.h"

#include "vtkActor.h"
#include "vtkCell.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>
#include <set>

namespace
{
using namespace tetmarch::testing;

constexpr int PickSize = 40;

struct Line
{
  Vec3 Near;
  Vec3 Direction; // unit length
};

Line lineOf(const Unprojection& unproject, int x, int y)
{
  const double u = 2.0 * (x + 0.5) / PickSize - 1.0;
  const double v = 2.0 * (y + 0.5) / PickSize - 1.0;
  const Vec3 near = unproject(u, v, -1.0);
  const Vec3 far = unproject(u, v, 1.0);
  const Vec3 d{ far[0] - near[0], far[1] - near[1], far[2] - near[2] };
  const double length = std::hypot(d[0], d[1], d[2]);
  return { near, { d[0] / length, d[1] / length, d[2] / length } };
}

double scalarAt(const LatticeTruth& truth, const Line& line, double length)
{
  for (const ScalarSegment& segment : truth.segments(line.Near, line.Direction))
  {
    if (segment.T0 <= length && length <= segment.T1)
    {
      return segment.Scalar.at((length - segment.T0) / (segment.T1 - segment.T0));
    }
  }
  return std::nan("");
}

void expectPicks(vtkDataSet* data, LatticeValues values, double threshold)
{
  StructuredScene scene(data, PickSize, PickSize);
  scene.draw(values);
  scene.Mapper->SetPickOpacityThreshold(threshold);
  scene.Window->Render();
  OpticalModel model;
  model.Colour = scene.property()->GetRGBTransferFunction();
  model.Opacity = scene.property()->GetScalarOpacity();
  model.UnitDistance = scene.property()->GetScalarOpacityUnitDistance();
  model.Law = OpacityLaw::Logarithmic;
  const LatticeTruth truth(data, model, values);
  const Unprojection unproject(scene.camera());
  const double slack = 1.0 / 255.0; // of an opacity, by the tolerance of the level
  double worstOpacity = 0.0;
  double worstScalar = 0.0;
  double outside = 0.0;
  int hits = 0;
  std::set<vtkIdType> cells;
  for (int y = 1; y < PickSize; y += 3)
  {
    for (int x = 2; x < PickSize; x += 4)
    {
      const Line line = lineOf(unproject, x, y);
      const bool hit = scene.Mapper->Pick(scene.Renderer, scene.Volume, x, y);
      const double depth = truth.depth(line.Near, line.Direction, 0.0, 10.0);
      const double opacity = -std::expm1(-depth);
      ASSERT_EQ(hit, std::abs(opacity - threshold) < slack ? hit : opacity > threshold)
        << x << ' ' << y << ' ' << opacity << " for " << threshold;
      if (!hit || opacity < threshold + slack)
      {
        continue;
      }
      ++hits;
      const double* p = scene.Mapper->GetPickedPosition();
      const double found = (p[0] - line.Near[0]) * line.Direction[0] +
                           (p[1] - line.Near[1]) * line.Direction[1] +
                           (p[2] - line.Near[2]) * line.Direction[2];
      const double before = -std::expm1(-truth.depth(line.Near, line.Direction, 0.0, found));
      worstOpacity = std::max(worstOpacity, std::abs(before - threshold));
      // At the place that was found: where the scalar jumps, that of either side.
      const double least =
        std::min(std::abs(scene.Mapper->GetPickedScalar() - scalarAt(truth, line, found - 1e-5)),
          std::abs(scene.Mapper->GetPickedScalar() - scalarAt(truth, line, found + 1e-5)));
      worstScalar = std::max(worstScalar, least);
      const vtkIdType id = scene.Mapper->GetPickedCellId();
      ASSERT_GE(id, 0);
      ASSERT_LT(id, data->GetNumberOfCells());
      cells.insert(id);
      double bounds[6];
      data->GetCellBounds(id, bounds);
      for (int a = 0; a < 3; ++a)
      {
        outside = std::max({ outside, bounds[2 * a] - p[a], p[a] - bounds[2 * a + 1] });
      }
    }
  }
  std::cout << "[ MEASURED ] " << data->GetClassName() << ", " << nameOf(values) << ", threshold "
            << threshold << ": " << hits << " hits in " << cells.size()
            << " cells, opacities within " << worstOpacity << ", scalars within " << worstScalar
            << ", points out of their cells by " << outside << '\n';
  EXPECT_GT(hits, 10);
  EXPECT_GT(cells.size(), 8u);
  EXPECT_LE(worstOpacity, slack);
  EXPECT_LE(worstScalar, 1e-3);
  EXPECT_LE(outside, 1e-5);
}

TEST(StructuredPick, AgainstTheGroundTruth)
{
  for (const double threshold : { 0.1, 0.6 })
  {
    for (const LatticeValues values : AllLatticeValues)
    {
      expectPicks(imageOf(scatteredField(1), unitCube(6)), values, threshold);
      expectPicks(imageOf(linearField(), unitCube(6)), values, threshold);
    }
    for (const LatticeValues values : { LatticeValues::PointsLinear, LatticeValues::CellsLinear })
    {
      expectPicks(rectilinearOf(linearField(), unevenCube(6)), values, threshold);
    }
  }
}

// Scalars below 0.8 are transparent, and rays leap over blocks of them.
TEST(StructuredPick, BehindEmptySpace)
{
  StructuredScene scene(imageOf(sineField(1.5), unitCube(32)), PickSize, PickSize);
  vtkPiecewiseFunction* opacity = scene.property()->GetScalarOpacity();
  opacity->RemoveAllPoints();
  opacity->AddPoint(0.8, 0.0);
  opacity->AddPoint(0.81, 0.9);
  scene.property()->SetScalarOpacityUnitDistance(1e-3);
  const Image drawn = scene.render();
  int hits = 0;
  int misses = 0;
  for (int x = 1; x < PickSize; x += 2)
  {
    const bool hit = scene.Mapper->Pick(scene.Renderer, scene.Volume, x, PickSize / 2);
    const float alpha = drawn.pixel(x, PickSize / 2)[3];
    EXPECT_EQ(hit, std::abs(alpha - 0.5f) < 0.01f ? hit : alpha > 0.5f) << x;
    hits += hit;
    misses += !hit;
    if (hit)
    {
      EXPECT_GE(scene.Mapper->GetPickedScalar(), 0.8 - 1e-5);
    }
  }
  EXPECT_GT(hits, 4);
  EXPECT_GT(misses, 2);
}

TEST(StructuredPick, OpaqueGeometryHidesTheVolume)
{
  StructuredScene scene(imageOf(sineField(), unitCube(8)), PickSize, PickSize);
  const int middle = PickSize / 2;
  ASSERT_TRUE(scene.Mapper->Pick(scene.Renderer, scene.Volume, middle, middle));
  scene.Renderer->AddActor(makeBall({ 1.3, 0.92, 1.7 }, 0.2, { 1.0, 1.0, 1.0 }));
  EXPECT_FALSE(scene.Mapper->Pick(scene.Renderer, scene.Volume, middle, middle));
}
} // namespace
