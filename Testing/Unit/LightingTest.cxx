// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Lights of a renderer and what a property answers to them.
#include "LightsOfRenderer.h"

#include "vtkMatrix4x4.h"

#include <gtest/gtest.h>
#include <limits>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

constexpr double Inf = std::numeric_limits<double>::infinity();

TEST_F(LightsOf, Headlight)
{
  this->add()->SetLightTypeToHeadlight();
  const LightSource source = this->only();
  EXPECT_TRUE(source.Headlight);
  EXPECT_FALSE(source.Positional);
  expectNear(source.Direction, 0.0, 0.0, -1.0);
  EXPECT_EQ(source.ShadowStrength, 1.0);
}

// A light at the camera with attenuation and a cone is no headlight.
TEST_F(LightsOf, PositionalHeadlight)
{
  const auto light = this->add();
  light->SetLightTypeToHeadlight();
  light->PositionalOn();
  const LightSource source = this->only();
  EXPECT_FALSE(source.Headlight);
  EXPECT_TRUE(source.Positional);
  expectNear(source.Position, 1.0, 2.0, 8.0);
  expectNear(source.Direction, 0.0, 0.0, -1.0);
  EXPECT_EQ(source.ShadowStrength, 1.0);
}

// Camera lights are placed in coordinates in which the camera looks from (0, 0, 1) to the origin.
TEST_F(LightsOf, CameraLight)
{
  const auto light = this->add();
  light->SetLightTypeToCameraLight();
  light->SetPosition(1.0, 0.0, 0.0);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  expectNear(this->only().Direction, -1.0, 0.0, 0.0);
  this->Camera->SetPosition(6.0, 2.0, 3.0); // it looks along -x now, and its right is -z
  expectNear(this->only().Direction, 0.0, 0.0, 1.0);
  EXPECT_FALSE(this->only().Headlight);
  light->PositionalOn();
  expectNear(
    this->only().Position, 1.0, 2.0, -2.0); // from the focal point, at the camera's distance
}

TEST_F(LightsOf, DirectionalSceneLight)
{
  const auto light = this->add();
  light->SetPosition(0.0, 3.0, 4.0);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetAttenuationValues(1.0, 2.0, 3.0);
  const LightSource source = this->only();
  EXPECT_FALSE(source.Positional);
  EXPECT_FALSE(source.Headlight);
  expectNear(source.Direction, 0.0, -0.6, -0.8);
  expectNear(source.Attenuation, 1.0, 0.0, 0.0);
  EXPECT_EQ(source.ConeCosine, -1.0);
  EXPECT_EQ(source.ShadowStrength, 1.0);
}

TEST_F(LightsOf, TransformMatrixOfASceneLight)
{
  vtkNew<vtkTransform> transform;
  transform->Translate(10.0, 0.0, 0.0);
  transform->RotateZ(90.0);
  const auto light = this->add();
  light->PositionalOn();
  light->SetPosition(2.0, 0.0, 0.0);
  light->SetTransformMatrix(transform->GetMatrix());
  const LightSource source = this->only();
  expectNear(source.Position, 10.0, 2.0, 0.0);
  expectNear(source.Direction, 0.0, -1.0, 0.0);
}

TEST_F(LightsOf, PointAndSpot)
{
  const auto light = this->add();
  light->PositionalOn();
  light->SetPosition(5.0, 6.0, 7.0);
  light->SetFocalPoint(5.0, 6.0, 0.0);
  light->SetAttenuationValues(0.5, 0.25, 0.125);
  light->SetExponent(3.0);
  light->SetConeAngle(60.0);
  const LightSource spot = this->only();
  expectNear(spot.Position, 5.0, 6.0, 7.0);
  expectNear(spot.Direction, 0.0, 0.0, -1.0);
  expectNear(spot.Attenuation, 0.5, 0.25, 0.125);
  EXPECT_NEAR(spot.ConeCosine, 0.5, 1e-12);
  EXPECT_EQ(spot.Exponent, 3.0);
  light->SetConeAngle(90.0);
  EXPECT_NEAR(this->only().ConeCosine, 0.0, 1e-12);
  for (const double angle : { 90.5, 180.0, Inf })
  {
    light->SetConeAngle(angle);
    EXPECT_EQ(this->only().ConeCosine, -1.0);
    EXPECT_EQ(this->only().Exponent, 0.0);
  }
}

TEST_F(LightsOf, ColoursTimesIntensity)
{
  const auto light = this->add();
  light->SetAmbientColor(0.1, 0.2, 0.3);
  light->SetDiffuseColor(0.4, 0.5, 0.6);
  light->SetSpecularColor(0.7, 0.8, 0.9);
  light->SetIntensity(2.0);
  const LightSource source = this->only();
  expectNear(source.Ambient, 0.2, 0.4, 0.6);
  expectNear(source.Diffuse, 0.8, 1.0, 1.2);
  expectNear(source.Specular, 1.4, 1.6, 1.8);
}

TEST_F(LightsOf, ShadowStrength)
{
  const auto light = this->add();
  const float cases[][2] = { { 0.0f, 0.0f }, { 0.25f, 0.25f }, { 1.0f, 1.0f }, { 3.0f, 1.0f },
    { -1.0f, 0.0f }, { std::numeric_limits<float>::quiet_NaN(), 0.0f } };
  for (const auto& c : cases)
  {
    light->SetShadowAttenuation(c[0]);
    EXPECT_EQ(this->only().ShadowStrength, static_cast<double>(c[1])) << c[0];
  }
}

TEST_F(LightsOf, WhatThePropertySays)
{
  this->add()->SetLightTypeToHeadlight();
  this->Property->SetAmbient(0.1);
  this->Property->SetDiffuse(0.2);
  this->Property->SetSpecular(0.3);
  this->Property->SetSpecularPower(40.0);
  this->Renderer->TwoSidedLightingOff();
  const Lighting lighting = this->lighting();
  EXPECT_EQ(lighting.Ambient, 0.1);
  EXPECT_EQ(lighting.Diffuse, 0.2);
  EXPECT_EQ(lighting.Specular, 0.3);
  EXPECT_EQ(lighting.SpecularPower, 40.0);
  EXPECT_FALSE(lighting.TwoSided);
  this->Renderer->TwoSidedLightingOn();
  EXPECT_TRUE(this->lighting().TwoSided);
}

TEST_F(LightsOf, DirectionsOfAnyLength)
{
  const auto light = this->add();
  for (const double length : { 1e-300, 1e300 })
  {
    light->SetPosition(3.0 * length, 0.0, 4.0 * length);
    expectNear(this->only().Direction, -0.6, 0.0, -0.8);
  }
}
} // namespace
