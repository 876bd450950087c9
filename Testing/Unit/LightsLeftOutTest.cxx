// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which lights of a renderer count, and which are left out.
#include "LightsOfRenderer.h"

#include "vtkMath.h"

#include <gtest/gtest.h>
#include <limits>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

constexpr double Inf = std::numeric_limits<double>::infinity();

TEST_F(LightsOf, SeveralInOrder)
{
  for (const double x : { 1.0, 2.0, 3.0 })
  {
    const auto light = this->add();
    light->SetLightTypeToHeadlight();
    light->SetDiffuseColor(x, 0.0, 0.0);
    light->SetPositional(x == 2.0);
  }
  const Lighting lighting = this->lighting();
  ASSERT_EQ(lighting.Lights.size(), 3u);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(lighting.Lights[i].Diffuse[0], i + 1.0);
    EXPECT_EQ(lighting.Lights[i].Positional, i == 1);
  }
  EXPECT_EQ(lighting.LeftOut, 0);
}

TEST_F(LightsOf, DarkOnesAreLeftOut)
{
  this->add()->SwitchOff();
  this->add()->SetIntensity(0.0);
  this->add()->SetColor(0.0, 0.0, 0.0);
  EXPECT_TRUE(this->lighting().Lights.empty());
  const auto ambient = this->add();
  ambient->SetColor(0.0, 0.0, 0.0);
  ambient->SetAmbientColor(0.0, 0.5, 0.0);
  EXPECT_EQ(this->only().Ambient[1], 0.5);
  ambient->SwitchOff();
  this->add()->SetLightTypeToHeadlight();
}

TEST_F(LightsOf, NothingIsLitWithoutShadeOrLights)
{
  EXPECT_TRUE(this->lighting().Lights.empty());
  this->add();
  EXPECT_FALSE(this->lighting().Lights.empty());
  this->Property->ShadeOff();
  EXPECT_TRUE(this->lighting().Lights.empty());
}

TEST_F(LightsOf, AtMostSixteen)
{
  for (int i = 0; i < 25; ++i)
  {
    const auto light = this->add();
    light->SetIntensity(i % 5); // five of them dark
    light->SetDiffuseColor(i, 0.0, 0.0);
  }
  const Lighting lighting = this->lighting();
  ASSERT_EQ(lighting.Lights.size(), static_cast<std::size_t>(MostLights));
  EXPECT_EQ(lighting.Lights.back().Diffuse[0], 19.0 * 4.0);
  EXPECT_EQ(lighting.LeftOut, 4);
}

TEST_F(LightsOf, WithoutDirectionAreLeftOut)
{
  const auto light = this->add();
  light->SetPosition(1.0, 2.0, 3.0);
  light->SetFocalPoint(1.0, 2.0, 3.0);
  EXPECT_TRUE(this->lighting().Lights.empty());
  light->PositionalOn();
  EXPECT_TRUE(this->lighting().Lights.empty());
  // Shining in all directions it needs none.
  light->SetConeAngle(180.0);
  expectNear(this->only().Position, 1.0, 2.0, 3.0);
  EXPECT_DOUBLE_EQ(vtkMath::Norm(this->only().Direction.data()), 1.0);
}

TEST_F(LightsOf, WhatIsNotFiniteIsLeftOut)
{
  for (const double bad : { Inf, -Inf, std::numeric_limits<double>::quiet_NaN() })
  {
    this->Renderer->RemoveAllLights();
    this->add()->SetPosition(bad, 0.0, 0.0);
    this->add()->SetFocalPoint(0.0, bad, 0.0);
    this->add()->SetIntensity(bad);
    this->add()->SetAmbientColor(bad, 0.0, 0.0);
    this->add()->SetDiffuseColor(0.0, bad, 0.0);
    this->add()->SetSpecularColor(0.0, 0.0, bad);
    const auto attenuated = this->add();
    attenuated->PositionalOn();
    attenuated->SetAttenuationValues(1.0, bad, 0.0);
    const auto everywhere = this->add();
    everywhere->PositionalOn();
    everywhere->SetConeAngle(180.0);
    everywhere->SetPosition(0.0, bad, 0.0);
    const Lighting lighting = this->lighting();
    EXPECT_TRUE(lighting.Lights.empty());
    EXPECT_EQ(lighting.LeftOut, 0);
  }
}
} // namespace
