// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The uniforms that lights, property and options become.
#include "LitVolume.h"

#include "UnitMeshes.h"

#include <cmath>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

class LightUniformsOf : public LitVolume
{
};

TEST_F(LightUniformsOf, ColoursAreTimesTheProperty)
{
  LightSource light = sunlight({ { 0.0, 0.0, 1.0 } });
  light.Diffuse = { { 0.1, 0.2, 0.4 } };
  light.Specular = { { 1.0, 2.0, 4.0 } };
  this->Answers.Lights = { light };
  this->Answers.TwoSided = true;
  const LightUniforms lights = this->lights();
  expectNear(lights.Sources[0].Diffuse, { { 0.05, 0.1, 0.2 } }, 1e-15);
  expectNear(lights.Sources[0].Specular, { { 0.75, 1.5, 3.0 } }, 1e-15);
  EXPECT_EQ(lights.SpecularPower, 20.0);
  EXPECT_TRUE(lights.TwoSided);
  this->Answers.TwoSided = false;
  EXPECT_FALSE(this->lights().TwoSided);
}

TEST_F(LightUniformsOf, AmbientIsOnceAndOnceMoreForEachLightsOwn)
{
  LightSource light = headlight();
  this->Answers.Lights = { light };
  expectNear(this->lights().Ambient, { { 0.25, 0.25, 0.25 } }, 1e-15);
  light.Ambient = { { 0.0, 1.0, 2.0 } };
  this->Answers.Lights.push_back(light);
  light.Ambient = { { 0.4, 0.0, 1.0 } };
  this->Answers.Lights.push_back(light);
  expectNear(this->lights().Ambient, { { 0.35, 0.5, 1.0 } }, 1e-15);
}

// The first three that cast one, headlights apart: what is between a point and the eye is known.
TEST_F(LightUniformsOf, ChannelsOfShadows)
{
  LightSource none = sunlight({ { 0.0, 1.0, 0.0 } });
  none.ShadowStrength = 0.0;
  LightSource weak = pointLight({ { 9.0, 9.0, 9.0 } });
  weak.ShadowStrength = 0.5;
  const LightSource sun = sunlight({ { 0.0, 0.0, -1.0 } });
  this->Answers.Lights = { headlight(), none, sun, weak, sun, headlight(), sun, none, weak };
  const LightUniforms lights = this->lights();
  const int channels[] = { -1, -1, 0, 1, 2, -1, -1, -1, -1 };
  const double strengths[] = { 1.0, 0.0, 1.0, 0.5, 1.0, 1.0, 0.0, 0.0, 0.0 };
  ASSERT_EQ(lights.Sources.size(), 9u);
  for (int i = 0; i < 9; ++i)
  {
    EXPECT_EQ(lights.Sources[i].ShadowChannel, channels[i]) << i;
    EXPECT_EQ(lights.Sources[i].ShadowStrength, strengths[i]) << i;
  }
  ASSERT_EQ(lights.ShadowSources.size(), 3u);
  EXPECT_EQ(lights.ShadowSources[0][3], 0.0);
  EXPECT_EQ(lights.ShadowSources[1][3], 1.0);
  EXPECT_EQ(lights.ShadowSources[2], lights.ShadowSources[0]);
  EXPECT_EQ(lights.ShadowlessLights, 2);
  EXPECT_EQ(lights.LightsLeftOut, 0);
  this->Answers.LeftOut = 4;
  EXPECT_EQ(this->lights().LightsLeftOut, 4);
  EXPECT_TRUE(lights.hasHeadlightShadows());
  EXPECT_TRUE(lights.hasVolumeLight());
}

TEST_F(LightUniformsOf, ShadowsNobodyAskedFor)
{
  this->Options.Shadows = ShadowMethod::Off;
  const LightSource sun = sunlight({ { 0.0, 0.0, -1.0 } });
  this->Answers.Lights = { headlight(), sun, sun, sun, sun };
  const LightUniforms lights = this->lights();
  EXPECT_TRUE(lights.ShadowSources.empty());
  EXPECT_EQ(lights.ShadowlessLights, 0);
  EXPECT_FALSE(lights.hasHeadlightShadows());
  EXPECT_FALSE(lights.hasVolumeLight());
  for (const auto& source : lights.Sources)
  {
    EXPECT_EQ(source.ShadowStrength, 0.0);
    EXPECT_EQ(source.ShadowChannel, -1);
  }
  // What scatters light keeps it from what is behind.
  this->Options.Scattering = 0.5;
  EXPECT_EQ(this->lights().ShadowSources.size(), 3u);
  EXPECT_EQ(this->lights().ShadowlessLights, 1);
  EXPECT_TRUE(this->lights().hasHeadlightShadows());
  EXPECT_EQ(this->lights().ScatteringBlending, 0.25);
}

TEST_F(LightUniformsOf, KindsOfLights)
{
  this->Answers.Lights = { headlight() };
  EXPECT_TRUE(this->lights().isHeadlightOnly());
  EXPECT_FALSE(this->lights().hasVolumeLight());
  this->Answers.Lights = { sunlight({ { 0.0, 0.0, -1.0 } }) };
  EXPECT_FALSE(this->lights().isHeadlightOnly());
  this->Answers.Lights = { headlight(), headlight() };
  EXPECT_FALSE(this->lights().isHeadlightOnly());
}

// Lights are in the world's frame only where distances count, or where the volume's matrix changes
// angles.
TEST_F(LightUniformsOf, LightInTheWorld)
{
  this->Answers.Lights = { headlight(), sunlight({ { 0.0, 0.0, -1.0 } }) };
  EXPECT_FALSE(this->lights().InWorld);
  this->Transform->RotateWXYZ(40.0, 1.0, 2.0, 3.0);
  this->Transform->Scale(-1e-6, 1e-6, 1e-6);
  this->Transform->Translate(1e6, 2e6, 3e6);
  EXPECT_FALSE(this->lights().InWorld);
  this->Answers.Lights.push_back(pointLight({ { 1.0, 2.0, 3.0 } }));
  EXPECT_TRUE(this->lights().InWorld);
  this->Answers.Lights = { headlight() };
  EXPECT_FALSE(this->lights().InWorld);
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Transform->Identity();
    Triple factors{ { 2.0, 2.0, 2.0 } };
    factors[axis] = 2.0001;
    this->Transform->Scale(factors.data());
    this->Transform->RotateWXYZ(40.0, 1.0, 2.0, 3.0);
    EXPECT_TRUE(this->lights().InWorld) << axis;
  }
}

// The diagonal of the mesh's box is two radii.
TEST_F(LightUniformsOf, Reach)
{
  EXPECT_NEAR(built(jitteredLattice(2)).Frame.Radius, std::sqrt(0.75), 1e-12);
  this->Answers.Lights = { headlight() };
  const double cases[][2] = { { 0.0, 0.0 }, { 1.0, 2.0 },
    { 0.5, 2.0 * (1.0 - std::pow(0.5, 0.33)) }, { 0.9, 2.0 * (1.0 - std::pow(0.1, 0.33)) } };
  for (const auto& c : cases)
  {
    this->Options.Reach = c[0];
    EXPECT_NEAR(this->lights().Reach, c[1], 1e-12) << c[0];
  }
}

TEST_F(LightUniformsOf, OcclusionIsOfAmbientLight)
{
  this->Options.Shadows = ShadowMethod::Off;
  this->Options.OcclusionDirections = 40;
  this->Options.OcclusionRadius = 0.3;
  this->Answers.Lights = { headlight() };
  EXPECT_EQ(this->lights().OcclusionDirections, 0);
  this->Options.Occlusion = true;
  EXPECT_EQ(this->lights().OcclusionDirections, 40);
  EXPECT_DOUBLE_EQ(this->lights().OcclusionRadius, 0.6);
  EXPECT_TRUE(this->lights().hasVolumeLight());
  this->Answers.Ambient = 0.0;
  EXPECT_EQ(this->lights().OcclusionDirections, 0);
  EXPECT_FALSE(this->lights().hasVolumeLight());
}

TEST_F(LightUniformsOf, NothingIsLitWithoutLights)
{
  this->Options.Occlusion = true;
  this->Options.Scattering = 1.0;
  const LightUniforms lights = this->lights();
  EXPECT_TRUE(lights.Sources.empty());
  EXPECT_FALSE(lights.hasVolumeLight());
  EXPECT_FALSE(lights.hasHeadlightShadows());
  EXPECT_FALSE(lights.InWorld);
  EXPECT_EQ(lights.ScatteringBlending, 0.0);
  EXPECT_EQ(lights.Ambient, Triple{});
}
} // namespace
