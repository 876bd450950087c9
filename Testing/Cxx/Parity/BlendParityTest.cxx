// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the GL draws of a volume of each kind in each blend mode, pixel by pixel against the CPU
// reference.
#include "vtkTetMarchFrameStatistics.h"

#include "Lights.h"
#include "ParityScenes.h"

#include "vtkActor.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

template <typename Kind>
class BlendParity : public ::testing::Test
{
protected:
  // Of the value 0.5 the field of an image is all over some sides of the cube.
  static void expectParityOfModes(Shape shape, const std::string& what, void (*change)(Kind& scene))
  {
    Kind scene(shape);
    setSurfaces(scene.property(), { 0.35, 0.53, 0.72 });
    setShading(scene.property());
    addLight(scene.Renderer, 3.0, 4.0, 1.5);
    change(scene);
    for (const int mode : BlendModes)
    {
      scene.Mapper->SetBlendMode(mode);
      scene.expectParityButForEdges(what + ", blend mode " + std::to_string(mode));
    }
  }
};
TYPED_TEST_SUITE(BlendParity, ParityKinds, ParityKindNames);

TYPED_TEST(BlendParity, Noise)
{
  this->expectParityOfModes(
    Shape::Noise, "noise", [](TypeParam& scene) { scene.property()->ShadeOff(); });
}

TYPED_TEST(BlendParity, ConstantCells)
{
  this->expectParityOfModes(
    Shape::Hard, "cells", [](TypeParam& scene) { scene.drawConstantCells(); });
}

TYPED_TEST(BlendParity, OpaqueGeometryInside)
{
  this->expectParityOfModes(Shape::Hard, "opaque geometry",
    [](TypeParam& scene) {
      scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 1.0, 1.0 }));
    });
}

TYPED_TEST(BlendParity, CameraInside)
{
  this->expectParityOfModes(
    Shape::Plain, "inside", [](TypeParam& scene) { lookFromInside(scene.camera()); });
}

TYPED_TEST(BlendParity, AverageOverARange)
{
  TypeParam::forEachScalars(
    [](TypeParam& scene, const std::string& name)
    {
      scene.Mapper->SetBlendModeToAverageIntensity();
      const Image whole = scene.render();
      scene.Mapper->SetAverageIPScalarRange(0.45, 0.6);
      scene.expectParityButForEdges(name);
      EXPECT_GT(compare(scene.render(), whole).Rms, 10.0 / 255.0);
    });
}

// No segment is split. An extreme has no error; a sum has that of rounding and of the steps of
// integrals.
TEST(MeshBlend, CountersOfWhatIsExact)
{
  BlendScene scene(jitteredLattice(10, 0.15, 1, sineField()), 96, 96);
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
