// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// If light passes through cuts, the picture of a volume whose half is cut away is that of the other
// half alone.
#include "CutScene.h"
#include "LatticeGrids.h"
#include "Lights.h"
#include "ScenePage.h"
#include "StructuredScene.h"

#include <cmath>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;
using Settings = vtkTetMarchSettings;

constexpr int Cells = 16; // along each edge of the cube; nodes of light are four cells apart

struct Way
{
  const char* Name;
  int Shadows;
  double Tolerance;
  bool Occlusion;
};

// Light that does not depend on gradients, which differ where the half ends.
template <typename AnyScene>
Image pictureOf(AnyScene& scene, const Way& way, double diagonal)
{
  addLight(scene.Renderer, 2.0, 1.5, 4.0);
  scene.property()->ShadeOn();
  scene.property()->SetAmbient(way.Occlusion ? 1.0 : 0.0);
  scene.property()->SetDiffuse(way.Occlusion ? 0.0 : 1.0);
  scene.property()->SetSpecular(0.0);
  scene.Mapper->SetShadowMethod(way.Shadows);
  scene.Mapper->SetVolumetricScatteringBlending(way.Occlusion ? 0.0f : 2.0f);
  scene.Mapper->SetLightTolerance(way.Tolerance);
  scene.Mapper->SetAmbientOcclusion(way.Occlusion);
  scene.Mapper->SetAmbientOcclusionRadius(0.3 / diagonal);
  return scene.render();
}

template <typename AnyScene>
void expectLightOfHalf(AnyScene& whole, AnyScene& half, const Way& way)
{
  SCOPED_TRACE(way.Name);
  const Image alone = pictureOf(half, way, std::sqrt(2.25));
  addClippingPlane(whole, { 0.5, 0.5, 0.5 }, { 0.0, 0.0, -1.0 });
  const Image inItsShadow = pictureOf(whole, way, std::sqrt(3.0));
  whole.Mapper->LightThroughCutsOn();
  const Image lit = whole.render();
  keepScenePage(whole.Window);
  EXPECT_GT(compare(inItsShadow, alone).Max, 0.03);
  const Difference difference = compare(lit, alone);
  std::cout << "[ MEASURED ] " << way.Name << ": " << difference.text() << '\n';
  EXPECT_LE(difference.Percentile999, 1.0 / 255.0);
}

class LightThroughCuts : public testing::TestWithParam<Way>
{
};

TEST_P(LightThroughCuts, MeshesAreLitAsTheHalfAlone)
{
  Scene whole(jitteredLattice(Cells, 0.0, 1, sineField()), 64, 64);
  Scene half(
    maskedLattice(Cells, 0.0, 1, sineField(), [](int, int, int k) { return 2 * k < Cells; }), 64,
    64);
  expectLightOfHalf(whole, half, this->GetParam());
}

TEST_P(LightThroughCuts, ImagesAreLitAsTheHalfAlone)
{
  const Field field = sineField();
  ImagePlace place = unitCube(Cells);
  StructuredScene whole(imageOf(field, place));
  place.Extent[5] = Cells / 2;
  StructuredScene half(
    imageOf([&](double x, double y, double z) { return field(x, y, 0.5 * z); }, place));
  expectLightOfHalf(whole, half, this->GetParam());
}

INSTANTIATE_TEST_SUITE_P(By, LightThroughCuts,
  testing::Values(Way{ "AtVertices", Settings::SHADOWS_AT_VERTICES, 0.0, false },
    Way{ "AlongRays", Settings::SHADOWS_ALONG_RAYS, 0.0, false },
    Way{ "WithinTolerance", Settings::SHADOWS_ALONG_RAYS, 1.0 / 255.0, false },
    Way{ "Occlusion", Settings::SHADOWS_OFF, 0.0, true }),
  [](const auto& of) { return std::string(of.param.Name); });
} // namespace
