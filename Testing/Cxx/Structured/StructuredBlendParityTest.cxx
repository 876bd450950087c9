// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the GL draws of a structured volume in each blend mode, pixel by pixel against the CPU
// reference.
#include "StructuredScene.h"

#include "vtkActor.h"

#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch::testing;
using Mapper = vtkTetMarchSmartVolumeMapper;

constexpr int BlendModes[] = { Mapper::COMPOSITE_BLEND, Mapper::MAXIMUM_INTENSITY_BLEND,
  Mapper::MINIMUM_INTENSITY_BLEND, Mapper::AVERAGE_INTENSITY_BLEND, Mapper::ADDITIVE_BLEND,
  Mapper::ISOSURFACE_BLEND };

void prepare(StructuredScene& scene)
{
  // Not 0.5, the value of the field all over some sides of the cube.
  scene.setSurfaces({ 0.35, 0.53, 0.72 });
  scene.addLight(3.0, 4.0, 1.5);
  setShading(scene.property());
}

void expectAllModes(StructuredScene& scene, const std::string& what)
{
  for (const int mode : BlendModes)
  {
    scene.Mapper->SetBlendMode(mode);
    const std::string named = what + ", blend mode " + std::to_string(mode);
    SCOPED_TRACE(named);
    expectParityButForEdges(scene, named);
  }
}

TEST(StructuredBlend, Noise)
{
  StructuredScene scene(imageOf(scatteredField(1), unitCube(6)), 40, 40);
  prepare(scene);
  scene.property()->ShadeOff();
  expectAllModes(scene, "noise");
}

TEST(StructuredBlend, AverageOverARange)
{
  StructuredScene scene(imageOf(sineField(), unitCube(9)), 40, 40);
  scene.Mapper->SetBlendModeToAverageIntensity();
  scene.Mapper->SetAverageIPScalarRange(0.45, 0.6);
  const Image drawn = scene.render();
  for (const LatticeValues values : AllLatticeValues)
  {
    scene.draw(values);
    expectParityButForEdges(scene, std::string("average over a range, ") + nameOf(values));
  }
  scene.draw(LatticeValues::PointsLinear);
  scene.Mapper->SetAverageIPScalarRange(VTK_FLOAT_MIN, VTK_FLOAT_MAX);
  EXPECT_GT(compare(drawn, scene.render()).Rms, 10.0 / 255.0);
}

TEST(StructuredBlend, OpaqueGeometryAndCameraInside)
{
  StructuredScene scene(imageOf(sineField(), unitCube(9)), 40, 40);
  prepare(scene);
  scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 1.0, 1.0 }));
  expectAllModes(scene, "opaque geometry");
  lookFromInside(scene.camera());
  expectAllModes(scene, "camera inside");
}

} // namespace
