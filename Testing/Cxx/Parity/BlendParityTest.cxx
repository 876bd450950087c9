// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the GL draws in each blend mode, pixel by pixel against the CPU reference.
#include "vtkTetMarchFrameStatistics.h"

#include "BlendParity.h"

#include "vtkActor.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 96;

Grid lattice() { return jitteredLattice(10, 0.15, 1, sineField()); }

TEST(BlendParity, AverageOverARange)
{
  BlendScene scene(lattice(), Side, Side);
  scene.Mapper->SetBlendModeToAverageIntensity();
  scene.Mapper->SetAverageIPScalarRange(0.45, 0.6);
  const Image drawn = scene.render();
  const Difference difference = compare(drawn, referenceOf(scene).Picture, regionsOf(scene).Inside);
  EXPECT_LE(50 * difference.Over, difference.Pixels) << difference.text();
  scene.Mapper->SetAverageIPScalarRange(VTK_FLOAT_MIN, VTK_FLOAT_MAX);
  EXPECT_GT(compare(drawn, scene.render()).Rms, 10.0 / 255.0);
}

TEST(BlendParity, OpaqueGeometryInside)
{
  BlendScene scene(lattice(), Side, Side);
  scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 1.0, 1.0 }));
  expectBlendParity(scene, true);
}

TEST(BlendParity, CameraInside)
{
  BlendScene scene(lattice(), Side, Side);
  lookFromInside(scene.camera());
  expectBlendParity(scene);
}

TEST(BlendParity, RaysThatComeAgain)
{
  BlendScene scene(latticeWithHole(9, 0.15, 1, sineField()), Side, Side);
  expectBlendParity(scene);
  BlendScene cells(nestedShells(10, 4, 0.15, 1, sineField()), Side, Side);
  cells.drawCellScalars();
  expectBlendParity(cells);
}

// No segment is split. An extreme has no error; a sum has that of rounding and of the steps of
// integrals.
TEST(BlendParity, CountersOfWhatIsExact)
{
  BlendScene scene(lattice(), Side, Side);
  for (const int mode : { Mapper::MAXIMUM_INTENSITY_BLEND, Mapper::ADDITIVE_BLEND })
  {
    scene.Mapper->SetBlendMode(mode);
    scene.render();
    EXPECT_LE(scene.Mapper->GetNumberOfLookups(), scene.Mapper->GetNumberOfCrossedCells());
    EXPECT_GT(scene.Mapper->GetNumberOfLookups(), scene.Mapper->GetNumberOfCrossedCells() * 9 / 10);
    const auto* statistics = scene.Mapper->GetLastFrameStatistics();
    const double bound = statistics->GetMaximum(vtkTetMarchFrameStatistics::ERROR_BOUND);
    const bool isSum = mode == Mapper::ADDITIVE_BLEND;
    EXPECT_TRUE(isSum ? bound > 0 && bound < 1e-5 : bound == 0) << mode << ": " << bound;
  }
  // As many as there are cells with a surface in them.
  scene.Mapper->SetBlendModeToIsoSurface();
  scene.render();
  EXPECT_LT(scene.Mapper->GetNumberOfLookups(), scene.Mapper->GetNumberOfCrossedCells() / 2);
  EXPECT_LE(
    scene.Mapper->GetLastFrameStatistics()->GetMaximum(vtkTetMarchFrameStatistics::ERROR_BOUND),
    1.0 / 255.0);
}
} // namespace
