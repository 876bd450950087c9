// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Light where rays towards it are hard: along faces and edges, from and to vertices, from inside of
// the volume, far away, behind a hole, in dense cells. Every way of computing shadows stays within
// 0 to 1 and loses no ray; with a tolerance, 99.9 % of the pixels keep it.
#include "CpuReference.h"
#include "Lights.h"
#include "NonConvexGrids.h"
#include "StructuredScene.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch::testing;
using tetmarch::LightAt;
using Settings = vtkTetMarchSettings;

constexpr int Cells = 8; // along each edge of the cube: its middle is a vertex

struct Case
{
  const char* Name;
  Vec3 Light;
  bool IsPoint;        // else at infinity
  double UnitDistance; // of 1 and less opacity
  bool HasHole = false;
  bool IsAmbient = false; // most of the light, and occluded
  float Scattering = 1.5f;
};

const Case Cases[] = {
  { "AlongEdges", { 9.0, 0.5, 0.5 }, false, 0.25 },
  { "InThePlaneOfFaces", { 4.5, 4.5, 0.5 }, false, 0.25 },
  { "AtAVertex", { 0.5, 0.5, 0.5 }, true, 0.25 },
  { "BesideAVertex", { 0.5 + 1e-9, 0.5, 0.5 }, true, 0.25 },
  { "OnAFace", { 0.5, 0.53, 0.56 }, true, 0.25 },
  { "VeryFarAway", { 3e12, 4e12, 1.5e12 }, true, 0.25 },
  { "BehindAHole", { 0.5, 0.5, 9.0 }, false, 0.25, true },
  { "DenseCells", { 3.0, 4.0, 1.5 }, false, 0.001 },
  { "DenseCellsFromInside", { 0.45, 0.55, 0.6 }, true, 0.004 },
  { "AmbientOcclusion", { 3.0, 4.0, 1.5 }, false, 0.02, true, true },
};

template <typename AnyScene>
void shine(AnyScene& scene, const Case& test)
{
  const auto light = addLight(scene.Renderer, test.Light[0], test.Light[1], test.Light[2]);
  light->SetPositional(test.IsPoint);
  light->SetConeAngle(180.0);
  scene.property()->ShadeOn();
  scene.property()->SetAmbient(test.IsAmbient ? 0.7 : 0.2);
  scene.Mapper->SetAmbientOcclusion(test.IsAmbient);
  scene.property()->SetDiffuse(test.IsAmbient ? 0.3 : 0.8);
  scene.property()->SetSpecular(0.0);
  scene.property()->SetScalarOpacityUnitDistance(test.UnitDistance);
  scene.Mapper->SetVolumetricScatteringBlending(test.Scattering);
  scene.Mapper->SetAccuracyLevelToAccurate();
}

Image truthOf(Scene& scene)
{
  return referenceOf(scene, {}, Precision::Double, LightAt::Points).Picture;
}
Image truthOf(StructuredScene& scene) { return scene.drawnWith(LightAt::Points); }

void expectColors(const Image& image)
{
  for (const float value : image.Rgba)
  {
    ASSERT_TRUE(value >= -1e-6f && value <= 1.00001f) << value;
  }
}

template <typename AnyScene>
void expectSoundLight(AnyScene& scene, const Case& test)
{
  shine(scene, test);
  for (const int method : { Settings::SHADOWS_AT_VERTICES, Settings::SHADOWS_ALONG_RAYS })
  {
    scene.Mapper->SetShadowMethod(method);
    expectColors(scene.render());
    EXPECT_EQ(scene.Mapper->GetLastFrameStatistics()->GetNumberOfLostRays(), 0);
  }
  constexpr double tolerance = 2.0 / 255.0;
  scene.Mapper->SetLightTolerance(tolerance);
  const Image drawn = scene.render();
  expectColors(drawn);
  EXPECT_EQ(scene.Mapper->GetLastFrameStatistics()->GetNumberOfLostRays(), 0);
  const Difference difference = compare(drawn, truthOf(scene), {}, tolerance);
  std::cout << "[ MEASURED ] " << test.Name << ": " << difference.text() << '\n';
  EXPECT_LE(1000 * difference.Over, difference.Pixels);
  EXPECT_LE(difference.Rms, 0.3 / 255.0);
}

class LightHardCases : public testing::TestWithParam<Case>
{
};

TEST_P(LightHardCases, InMeshes)
{
  const Grid grid = this->GetParam().HasHole ? latticeWithHole(Cells, 0.0, 1, sineField())
                                             : jitteredLattice(Cells, 0.0, 1, sineField());
  Scene scene(grid, 48, 48);
  expectSoundLight(scene, this->GetParam());
}

TEST_P(LightHardCases, InImages)
{
  StructuredScene scene(imageOf(sineField(), unitCube(Cells)), 48, 48);
  expectSoundLight(scene, this->GetParam());
}

// A cell with one gradient is not integrated in parts, but divided by samples. All light is
// scattered: a surface has the one shade of its cell, which no tolerance changes.
TEST(LightInDenseCells, WithOneGradientEach)
{
  Scene scene(jitteredLattice(Cells, 0.0, 1, sineField()), 48, 48);
  scene.Mapper->SetGradientTypeToCell();
  expectSoundLight(
    scene, { "WithOneGradientEach", { 3.0, 4.0, 1.5 }, false, 0.004, false, false, 2.0f });
}

// A dense wire in fog. On llvmpipe, a ray through this many cells evaluates light at some 100
// points at most (Shaders/light/sampled_shadows_adaptive.glsl). They suffice if they lie where
// light changes.
TEST(LightInManyCells, AWire)
{
  const auto wire = [](double x, double y, double)
  { return std::hypot(x - 0.35, y - 0.6) < 0.04 ? 0.9 : 0.3 + 0.1 * x; };
  StructuredScene scene(imageOf(wire, unitCube(128)), 40, 40);
  expectSoundLight(scene, { "AWireInManyCells", { -7.0, 6.0, 2.0 }, false, 0.25 });
}

INSTANTIATE_TEST_SUITE_P(With, LightHardCases, testing::ValuesIn(Cases),
  [](const auto& of) { return std::string(of.param.Name); });
} // namespace
