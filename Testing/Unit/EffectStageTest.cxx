// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The data of effects are made when a scene calls for them, once, and are gone when it doesn't.
#include "StagedEffects.h"

#include "ScarceMemory.h"

#include "vtkCellData.h"

#include <cmath>
#include <tuple>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

class Effects : public StagedEffects
{
};

TEST_F(Effects, APlainSceneMakesNothing)
{
  this->expectRuns(0, 0, 0);
  this->expectNothing();
  // Whatever is asked of light, there is none, or nothing that it shines on.
  this->Options = { true, ShadowMethod::AtVertices, 2.0, 1.0, true, 0.5, 32 };
  this->addSun();
  this->expectRuns(0, 0, 0);
  this->expectNothing();
  this->property()->ShadeOn();
  this->Renderer->RemoveAllLights();
  this->expectRuns(0, 0, 0);
  this->expectNothing();
}

// Whatever property and renderer say of light.
TEST_F(Effects, PresetsShineByThemselves)
{
  this->addSun();
  for (const auto& [preset, lights, channels] :
    { std::tuple(LightPreset::Studio, 3u, 0u), { LightPreset::Sun, 1u, 1u },
      { LightPreset::Headlight, 1u, 0u }, { LightPreset::OfScene, 0u, 0u } })
  {
    this->Options.Preset = preset;
    EXPECT_EQ(this->update(), "");
    EXPECT_EQ(this->Stage.data().Lights.Sources.size(), lights) << int(preset);
    EXPECT_EQ(this->Stage.data().Lights.ShadowSources.size(), channels) << int(preset);
    EXPECT_EQ(this->key().Occlusion, lights > 1 || channels > 0) << int(preset);
  }
}

TEST_F(Effects, EachMakesWhatItNeeds)
{
  this->property()->ShadeOn();
  this->property()->SetAmbient(0.0);
  this->addHeadlight();
  this->expectRuns(1, 0, 0);
  EXPECT_EQ(this->Stage.data().Gradients.size(), this->Mesh.Vertices.size());
  EXPECT_TRUE(this->key().HeadlightOnly);
  this->Options.Shadows = ShadowMethod::AtVertices; // what the eye sees is known
  this->Options.Occlusion = true;                   // of no ambient light
  this->expectRuns(1, 0, 0);
  EXPECT_TRUE(this->key().HeadlightShadows);
  EXPECT_FALSE(this->key().hasVertexLight());
  this->property()->SetAmbient(0.1);
  this->expectRuns(1, 0, 1);
  EXPECT_EQ(this->Stage.data().VertexStarts.size(), this->Mesh.Vertices.size());
  EXPECT_TRUE(this->key().Occlusion);
  this->Options.Occlusion = false;
  this->expectRuns(1, 0, 1);
  EXPECT_EQ(this->Stage.data().VertexStarts.capacity(), 0u);
  this->addSun();
  this->expectRuns(1, 0, 2);
  EXPECT_TRUE(this->key().CastShadows);
  this->addGradientOpacity();
  this->expectRuns(1, 1, 2);
  EXPECT_TRUE(this->key().GradientOpacity);
}

TEST_F(Effects, WhatNothingCallsForIsFreed)
{
  this->property()->ShadeOn();
  this->addSun();
  this->addGradientOpacity();
  this->Options.Shadows = ShadowMethod::AtVertices;
  this->expectRuns(1, 1, 1);
  this->property()->ShadeOff();
  this->expectRuns(1, 1, 1);
  EXPECT_EQ(this->Stage.data().VertexStarts.capacity(), 0u);
  EXPECT_FALSE(this->Stage.data().Gradients.empty());
  this->property()->DisableGradientOpacityOn();
  this->expectRuns(1, 1, 1);
  this->expectNothing();
  this->property()->DisableGradientOpacityOff();
  this->property()->ShadeOn();
  this->expectRuns(2, 2, 2);
  this->Stage.clear();
  this->expectNothing();
  this->expectRuns(3, 3, 3);
}

TEST_F(Effects, GradientsToLookAt)
{
  this->Options.Shown = Subject::Gradients;
  this->expectRuns(1, 0, 0);
  EXPECT_TRUE(this->key().ShowGradients);
  this->Options.Shown = Subject::Illumination; // which needs no light
  this->expectRuns(1, 0, 0);
  EXPECT_EQ(this->Stage.data().Gradients.capacity(), 0u);
}

TEST_F(Effects, LightsPropertyAndCameraRerunNothing)
{
  this->property()->ShadeOn();
  this->Options.Shadows = ShadowMethod::AtVertices;
  this->Options.Occlusion = true;
  const auto light = this->addLight(3.0, 4.0, 1.0);
  this->addGradientOpacity();
  this->expectRuns(1, 1, 1);
  const Fingerprint gradients = this->Stage.gradientsVersion();
  const Fingerprint opacity = this->Stage.gradientOpacityVersion();
  const Fingerprint starts = this->Stage.startsVersion();
  light->SetPosition(-3.0, 4.0, 1.0);
  light->SetIntensity(0.3);
  light->SetColor(0.1, 0.2, 0.3);
  light->PositionalOn();
  this->addHeadlight();
  this->property()->SetAmbient(0.3);
  this->property()->SetDiffuse(0.3);
  this->property()->SetSpecular(0.3);
  this->property()->SetSpecularPower(30.0);
  this->property()->SetScalarOpacityUnitDistance(7.0);
  this->Renderer->GetActiveCamera()->SetPosition(3.0, 2.0, 1.0);
  this->Volume->RotateX(30.0);
  this->Options.Scattering = 1.2;
  this->Options.Reach = 0.2;
  this->Options.OcclusionRadius = 0.7;
  this->Options.OcclusionDirections = 99;
  this->Options.Shadows = ShadowMethod::AlongRays;
  this->expectRuns(1, 1, 1);
  EXPECT_EQ(this->Stage.gradientsVersion(), gradients);
  EXPECT_EQ(this->Stage.gradientOpacityVersion(), opacity);
  EXPECT_EQ(this->Stage.startsVersion(), starts);
  EXPECT_EQ(this->Stage.data().Lights.OcclusionDirections, 99);
}

TEST_F(Effects, NewScalarsAndMeshes)
{
  this->property()->ShadeOn();
  this->Options.Shadows = ShadowMethod::AtVertices;
  this->addSun();
  this->addGradientOpacity();
  this->expectRuns(1, 1, 1);
  this->touchScalars();
  this->expectRuns(2, 2, 1);
  this->touchMesh();
  this->expectRuns(3, 3, 2);
}

TEST_F(Effects, GradientsOfCells)
{
  this->property()->ShadeOn();
  this->addSun();
  this->expectRuns(1, 0, 0);
  this->Options.CellGradients = true;
  this->expectRuns(2, 0, 0);
  EXPECT_EQ(this->Stage.data().Gradients.size(), this->Mesh.Tets.size());
  EXPECT_TRUE(this->key().CellGradients);
  // Scalars of cells have no gradient within a cell.
  this->readData(true);
  this->expectRuns(3, 0, 0);
  EXPECT_EQ(this->Stage.data().Gradients.size(), this->Mesh.Vertices.size());
  EXPECT_FALSE(this->key().CellGradients);
}

TEST_F(Effects, GradientOpacityOfOneIsNone)
{
  vtkPiecewiseFunction* function = this->addGradientOpacity();
  function->RemoveAllPoints();
  function->AddPoint(0.0, 1.0);
  function->AddPoint(100.0, 1.0);
  this->expectRuns(1, 1, 0);
  EXPECT_TRUE(this->Stage.data().GradientOpacity.empty());
  EXPECT_FALSE(this->key().hasGradients());
  // An edit of the function leaves the gradients.
  function->AddPoint(0.0, 0.5);
  this->expectRuns(1, 2, 0);
  EXPECT_TRUE(this->key().GradientOpacity);
  function->AddPoint(0.0, 1.0);
  this->expectRuns(1, 3, 0);
  EXPECT_TRUE(this->key() == VariantKey().filtered());
}

// Of scalar units per unit of length of the data's coordinates.
TEST_F(Effects, GradientOpacityIsOfTheDatasUnits)
{
  const double scale = 40.0;
  this->Data =
    withOffsetAndScale(jitteredLattice(3, 0.15, 1, linearField()), { 5.0, 6.0, 7.0 }, scale);
  this->readData();
  vtkPiecewiseFunction* function = this->addGradientOpacity();
  function->RemoveAllPoints();
  function->AddPoint(0.0, 0.0);
  function->AddPoint(1.0, 1.0);
  this->expectRuns(1, 1, 0);
  const EffectData& data = this->Stage.data();
  const double magnitude = std::sqrt(0.04 + 0.09 + 0.25) / scale;
  for (const auto& g : data.Gradients)
  {
    const double length = std::hypot(double(g[0]), double(g[1]), double(g[2]));
    const double position = length * data.GradientOpacityScale;
    EXPECT_NEAR(position * data.GradientOpacity.Unit, magnitude, 1e-5 * magnitude);
    EXPECT_NEAR(data.GradientOpacity.Values[std::lround(position)], magnitude, 1e-3 * magnitude);
  }
}

TEST_F(Effects, WhereShadowsAreLookedFor)
{
  this->property()->ShadeOn();
  this->addSun();
  const double few = static_cast<double>(this->Mesh.Vertices.size()) / 8.0 - 1.0;
  const double many = few + 2.0;
  const struct
  {
    ShadowMethod Method;
    double Scattering;
    bool Casts;
    bool SampledOfFew;
    bool SampledOfMany;
  } cases[] = { { ShadowMethod::Off, 0.0, false, false, false },
    { ShadowMethod::Off, 0.5, true, true, false },
    { ShadowMethod::Automatic, 0.0, true, true, false },
    { ShadowMethod::AtVertices, 0.0, true, false, false },
    { ShadowMethod::AlongRays, 0.0, true, true, true } };
  for (const auto& c : cases)
  {
    SCOPED_TRACE(static_cast<int>(c.Method));
    this->Options.Shadows = c.Method;
    this->Options.Scattering = c.Scattering;
    EXPECT_EQ(this->update(), "");
    EXPECT_EQ(this->key(few).CastShadows, c.Casts);
    EXPECT_EQ(this->key(few).SampledShadows, c.SampledOfFew);
    EXPECT_EQ(this->key(many).SampledShadows, c.SampledOfMany);
  }
}

TEST_F(Effects, WithoutMemoryNothingIsLeft)
{
  this->property()->ShadeOn();
  this->addSun();
  this->Options.Shadows = ShadowMethod::AtVertices;
  this->expectRuns(1, 0, 1);
  this->touchMesh();
  {
    const ScarceMemory scarce(16 * this->Mesh.Vertices.size());
    EXPECT_NE(this->update().find("too little memory for the effects"), std::string::npos);
    EXPECT_GT(ScarceMemory::failures(), 0);
  }
  this->expectNothing();
  EXPECT_EQ(this->update(), "");
  EXPECT_EQ(this->Stage.data().VertexStarts.size(), this->Mesh.Vertices.size());
}
} // namespace
