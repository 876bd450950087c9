// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whole pictures of the CPU reference, pixel by pixel against the ground truth in world
// coordinates.
#include "View/View.h"

#include "Shot.h"

#include "vtkVolume.h"

#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <type_traits>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

constexpr int Size = Shot::Size;

template <typename Real>
void expectImage(
  const Image& groundTruth, const Shot& shot, const AccuracyLevel& level, double bound)
{
  MarchCounters counters;
  const Difference difference = compare(byReference<Real>(shot, level, counters), groundTruth);
  EXPECT_LE(difference.Max, bound) << difference.text();
  EXPECT_GT(counters.Rays, Size * Size / 20);
  EXPECT_GE(counters.Lookups, 0);
  EXPECT_EQ(counters.Refused + counters.Lost + counters.Guarded, 0);
  const std::string name = std::is_same<Real, float>::value ? "float" : "double";
  ::testing::Test::RecordProperty(
    name + std::to_string(level.LeastTableEntries), std::to_string(difference.Max * 255.0));
}

// The tolerances of the default level and of the ground truth: 1/255 and 1e-4.
void expectDefault(const Shot& shot)
{
  const Image groundTruth = byGroundTruth(shot);
  expectImage<float>(groundTruth, shot, DefaultAccuracy, 1.0 / 255.0);
  expectImage<double>(groundTruth, shot, DefaultAccuracy, 1.0 / 255.0);
}

void expectReference(const Shot& shot)
{
  expectImage<double>(byGroundTruth(shot), shot, GroundTruthAccuracy, 1e-4);
}

void expectShot(const Shot& shot)
{
  expectDefault(shot);
  expectReference(shot);
}

TEST(ReferenceImage, Perspective) { expectShot(Shot()); }

TEST(ReferenceImage, Parallel)
{
  Shot shot;
  shot.Camera->ParallelProjectionOn();
  shot.Camera->SetParallelScale(0.9);
  expectShot(shot);
}

TEST(ReferenceImage, Thick)
{
  Shot shot;
  shot.UnitDistance = 0.03;
  expectDefault(shot);
}

// Each segment is split many times here: see SegmentTest.cxx.
TEST(ReferenceImage, ThickReference)
{
  Shot shot;
  shot.UnitDistance = 0.03;
  expectReference(shot);
}

TEST(ReferenceImage, HoleAndTwoComponents)
{
  Shot hole;
  hole.Data = latticeWithHole(6, 0.15, 1, sineField());
  expectShot(hole);
  Shot two;
  two.Data = twoComponents(4, 0.15, 1, sineField());
  two.Camera->SetPosition(4.0, 1.0, 2.0);
  expectShot(two);
}

TEST(ReferenceImage, CellScalars)
{
  Shot shot;
  shot.Scalars = ScalarsOf::Cells;
  expectShot(shot);
}

TEST(ReferenceImage, MirroredAndNonUniform)
{
  Shot mirrored;
  mirrored.Transform->Scale(-1.0, 1.0, 1.0);
  mirrored.Transform->Translate(-1.0, 0.0, 0.0);
  expectShot(mirrored);
  Shot stretched;
  stretched.Transform->Translate(0.2, 0.3, -0.1);
  stretched.Transform->RotateWXYZ(35.0, 1.0, 2.0, 3.0);
  stretched.Transform->Scale(0.5, 1.7, -0.8);
  expectShot(stretched);
}

TEST(ReferenceImage, CameraInside)
{
  Shot shot;
  shot.Camera->SetPosition(0.31, 0.42, 0.57);
  shot.Camera->SetFocalPoint(1.0, 0.6, 0.4);
  shot.Camera->SetClippingRange(0.01, 5.0);
  expectShot(shot);
}

TEST(ReferenceImage, NearAndFarPlaneCut)
{
  Shot shot;
  shot.Camera->SetClippingRange(2.7, 3.4);
  expectShot(shot);
}

TEST(ReferenceImage, OpaqueDepthsCutInsideCells)
{
  for (const bool parallel : { false, true })
  {
    Shot shot;
    shot.Camera->SetParallelProjection(parallel);
    shot.Camera->SetParallelScale(0.9);
    shot.Camera->SetClippingRange(1.5, 5.0);
    for (int i = 0; i < Size * Size; ++i)
    {
      // From before the mesh to behind it.
      const double wave = 0.5 + 0.5 * std::sin(0.37 * (i % Size)) * std::cos(0.23 * (i / Size));
      const double z = 1.6 + 3.3 * wave;
      shot.Depths.push_back(static_cast<float>(
        parallel ? (z - 1.5) / 3.5 : (1.0 / 1.5 - 1.0 / z) / (1.0 / 1.5 - 1.0 / 5.0)));
    }
    expectShot(shot);
  }
}

TEST(ReferenceImage, FarAwayMesh)
{
  Shot shot;
  shot.Data = withOffsetAndScale(shot.Data, { 1e6, -2e6, 3e6 }, 1.0);
  shot.Transform->Translate(-1e6, 2e6, -3e6);
  expectShot(shot);
}

TEST(View, SingularMatricesShowNothing)
{
  const TetMesh mesh = built(singleTet());
  vtkNew<WindowlessRenderer> renderer;
  vtkNew<vtkCamera> camera;
  renderer->SetActiveCamera(camera);
  vtkNew<vtkVolume> volume;
  vtkNew<vtkTransform> flat;
  flat->Scale(1.0, 0.0, 1.0);
  volume->SetUserTransform(flat);
  View view;
  EXPECT_FALSE(
    makeView(renderer, volume, mesh.Frame, 1.0, tetmarch::OpacityLaw::Unstructured, view));
}
} // namespace
