// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Where the lights of presets shine from, and which effects go with them.
#include "LightsOfRenderer.h"

#include "Light/LightPreset.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;
using Triple = std::array<double, 3>;

constexpr double Length = 0.9974969; // of the sun's way, (-0.45, 0.7, 0.55)

void expectFrom(const LightSource& light, const Triple& from)
{
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_NEAR(light.Direction[k], -from[k], 1e-6) << k;
  }
}

// Up is the nearest axis. To the right is x, or y if x is up; the front is where a right-handed
// frame has it.
TEST_F(LightsOf, PresetOfTheSunStaysInTheWorld)
{
  const struct
  {
    Triple ViewUp, Right, Up, Front;
  } cases[] = {
    { { { 0, 1, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } },
    { { { 0.5, 0.7, -0.6 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } },
    { { { 0, 0, 1 } }, { { 1, 0, 0 } }, { { 0, 0, 1 } }, { { 0, -1, 0 } } },
    { { { 0.2, 0.3, -1 } }, { { 1, 0, 0 } }, { { 0, 0, -1 } }, { { 0, 1, 0 } } },
    { { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 1, 0, 0 } }, { { 0, 0, -1 } } },
  };
  for (const auto& c : cases)
  {
    SCOPED_TRACE(::testing::PrintToString(c.ViewUp));
    this->Camera->SetViewUp(c.ViewUp.data());
    for (const double x : { 1.0, 4.0 })
    {
      this->Camera->SetPosition(x, 2.0, 8.0);
      const Lighting lighting = presetLighting(LightPreset::Sun, this->Renderer);
      ASSERT_EQ(lighting.Lights.size(), 1u);
      EXPECT_EQ(lighting.Lights[0].ShadowStrength, 1.0);
      Triple from{};
      for (int k = 0; k < 3; ++k)
      {
        from[k] = (-0.45 * c.Right[k] + 0.7 * c.Up[k] + 0.55 * c.Front[k]) / Length;
      }
      expectFrom(lighting.Lights[0], from);
    }
  }
}

TEST_F(LightsOf, PresetOfTheStudioGoesWithTheCamera)
{
  const Lighting before = presetLighting(LightPreset::Studio, this->Renderer);
  ASSERT_EQ(before.Lights.size(), 3u);
  // Now the camera looks along -x, and -z is to its right.
  this->Camera->Azimuth(90.0);
  const Lighting after = presetLighting(LightPreset::Studio, this->Renderer);
  for (std::size_t i = 0; i < 3; ++i)
  {
    SCOPED_TRACE(i);
    const Triple& way = before.Lights[i].Direction;
    EXPECT_NEAR(std::hypot(way[0], way[1], way[2]), 1.0, 1e-12);
    EXPECT_EQ(before.Lights[i].ShadowStrength, 0.0) << "shadows would be made anew in each frame";
    expectFrom(after.Lights[i], { { -way[2], -way[1], way[0] } });
  }
  expectFrom(presetLighting(LightPreset::Headlight, this->Renderer).Lights[0], { { 1, 0, 0 } });
}

TEST_F(LightsOf, PresetsHaveTheirEffects)
{
  EffectOptions options;
  options.Shadows = ShadowMethod::AlongRays;
  EXPECT_FALSE(withPreset(options).Occlusion);
  options.Preset = LightPreset::Sun;
  EXPECT_TRUE(withPreset(options).Occlusion);
  EXPECT_EQ(withPreset(options).Shadows, ShadowMethod::AlongRays) << "which was asked for";
  options.Shadows = ShadowMethod::Off;
  EXPECT_EQ(withPreset(options).Shadows, ShadowMethod::Automatic);
  options.Preset = LightPreset::Studio;
  EXPECT_EQ(withPreset(options).Shadows, ShadowMethod::Off);
  options.Preset = LightPreset::Headlight;
  EXPECT_FALSE(withPreset(options).Occlusion);
  EXPECT_TRUE(presetLighting(LightPreset::Headlight, this->Renderer).Lights[0].Headlight);
}
} // namespace
