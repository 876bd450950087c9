// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the GL draws in each blend mode, pixel by pixel against the CPU twin.
#include "vtkTetMarchFrameStatistics.h"

#include "BlendScene.h"
#include "Twin.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>
#include <iostream>
#include <limits>

namespace
{
using namespace tetmarch::testing;

Grid lattice() { return jitteredLattice(10, 0.15, 1, sineField()); }

// What shows scalars where they jump, or surfaces, has edges inside the silhouette, where rounding
// decides which side a pixel sees.
constexpr std::size_t PixelsAnEdgeCosts = 250; // one of so many

void expectModes(Scene& scene, bool opaque = false)
{
  for (const int mode : BlendModes)
  {
    scene.Mapper->SetBlendMode(mode);
    const Image drawn = scene.render();
    const std::vector<float> depths = opaque ? scene.windowDepths() : std::vector<float>();
    const TwinPicture twin = twinOf(scene, depths);
    const Regions regions = regionsOf(scene, depths);
    const Difference inside = compare(drawn, twin.Picture, regions.Inside);
    std::cout << "[ MEASURED ] " << scene.Mapper->GetBlendModeAsString() << ": " << inside.text()
              << '\n';
    EXPECT_GT(inside.Pixels, 400u);
    EXPECT_LE(inside.Over * PixelsAnEdgeCosts, inside.Pixels)
      << scene.Mapper->GetBlendModeAsString() << ": " << inside.text();
    EXPECT_LE(inside.Percentile999, 8.0 / 255.0) << inside.text();
    const Image nothing(drawn.Width, drawn.Height);
    EXPECT_EQ(compare(drawn, nothing, regions.Outside, 0.0).Over, 0u) << "something outside";
    EXPECT_GT(compare(drawn, nothing, regions.Inside).Max, 0.1) << "nothing inside";
    EXPECT_EQ(scene.Mapper->GetNumberOfLostRays(), 0);
    EXPECT_EQ(scene.Mapper->GetNumberOfGuardHits(), 0);
  }
}

void goInside(vtkCamera* camera)
{
  camera->SetPosition(0.31, 0.42, 0.57);
  camera->SetFocalPoint(1.0, 0.6, 0.4);
  camera->SetClippingRange(0.01, 5.0);
}

TEST(BlendParity, ScalarsOfPoints)
{
  BlendScene scene(lattice());
  expectModes(scene);
}

TEST(BlendParity, ScalarsOfCells)
{
  BlendScene scene(jitteredLattice(8, 0.15, 1, sineField()));
  scene.drawCellScalars();
  expectModes(scene);
}

TEST(BlendParity, InNoLight)
{
  BlendScene scene(lattice());
  scene.property()->ShadeOff();
  expectModes(scene);
}

TEST(BlendParity, GradientsOfCells)
{
  BlendScene scene(lattice());
  scene.Mapper->SetGradientType(Mapper::CELL_GRADIENTS);
  expectModes(scene);
}

TEST(BlendParity, AverageOverARange)
{
  BlendScene scene(lattice());
  scene.Mapper->SetBlendModeToAverageIntensity();
  scene.Mapper->SetAverageIPScalarRange(0.45, 0.6);
  const Image drawn = scene.render();
  const Difference difference = compare(drawn, twinOf(scene).Picture, regionsOf(scene).Inside);
  EXPECT_LE(50 * difference.Over, difference.Pixels) << difference.text();
  scene.Mapper->SetAverageIPScalarRange(VTK_FLOAT_MIN, VTK_FLOAT_MAX);
  EXPECT_GT(compare(drawn, scene.render()).Rms, 10.0 / 255.0);
}

TEST(BlendParity, OpaqueGeometryInside)
{
  BlendScene scene(lattice());
  scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 1.0, 1.0 }));
  expectModes(scene, true);
}

TEST(BlendParity, CameraInside)
{
  BlendScene scene(lattice());
  goInside(scene.camera());
  expectModes(scene);
}

TEST(BlendParity, RaysThatComeAgain)
{
  BlendScene scene(latticeWithHole(9, 0.15, 1, sineField()));
  expectModes(scene);
  BlendScene cells(nestedShells(10, 4, 0.15, 1, sineField()));
  cells.drawCellScalars();
  expectModes(cells);
}

TEST(BlendParity, ScalarsThatAreNotFinite)
{
  const Grid grid = lattice();
  vtkDataArray* scalars = grid->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); i += 37)
  {
    scalars->SetComponent(i, 0, std::numeric_limits<double>::quiet_NaN());
  }
  BlendScene scene(grid);
  expectModes(scene);
}

// No piece is evaluated twice, and nothing is left to be bounded.
TEST(BlendParity, CountersOfWhatIsExact)
{
  BlendScene scene(lattice());
  for (const int mode : { Mapper::MAXIMUM_INTENSITY_BLEND, Mapper::ADDITIVE_BLEND })
  {
    scene.Mapper->SetBlendMode(mode);
    scene.render();
    EXPECT_LE(scene.Mapper->GetNumberOfEvaluations(), scene.Mapper->GetNumberOfCrossedCells());
    EXPECT_GT(
      scene.Mapper->GetNumberOfEvaluations(), scene.Mapper->GetNumberOfCrossedCells() * 9 / 10);
    const auto* statistics = scene.Mapper->GetLastFrameStatistics();
    EXPECT_EQ(statistics->GetMaximum(vtkTetMarchFrameStatistics::ERROR_BOUND), 0.0);
  }
  // As many as there are cells with a surface in them.
  scene.Mapper->SetBlendModeToIsoSurface();
  scene.render();
  EXPECT_LT(scene.Mapper->GetNumberOfEvaluations(), scene.Mapper->GetNumberOfCrossedCells() / 2);
  EXPECT_LE(
    scene.Mapper->GetLastFrameStatistics()->GetMaximum(vtkTetMarchFrameStatistics::ERROR_BOUND),
    1.0 / 255.0);
}
} // namespace
