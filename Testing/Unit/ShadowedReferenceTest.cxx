// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Shadows that the volume casts in itself, in pictures of the CPU reference: kept at vertices they
// are near those of every point.
#include "Light/EffectData.h"
#include "Mesh/Gradients.h"
#include "Mesh/VertexStarts.h"

#include "Images.h"
#include "Shot.h"

#include <cmath>
#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

double meanRed(const ReferenceImage& image)
{
  double sum = 0;
  for (std::size_t i = 0; i < image.Pixels.size(); i += 4)
  {
    sum += double(image.Pixels[i]);
  }
  return sum / static_cast<double>(image.Pixels.size() / 4);
}

double rmsBetween(const ReferenceImage& a, const ReferenceImage& b)
{
  const auto imageOf = [](const ReferenceImage& reference)
  { return Image::fromFloats(Shot::Size, Shot::Size, reference.Pixels.data()); };
  return compare(imageOf(a), imageOf(b)).Rms;
}

// A shot of a volume that casts shadows in itself.
class SunlitShot
{
public:
  SunlitShot(const Shot& shot, const AccuracyLevel& level)
    : Level(level)
    , Marched(shot, level)
  {
    this->Effects.Gradients = vertexGradients(this->Marched.Mesh);
    this->Effects.VertexStarts = vertexStarts(this->Marched.Mesh);
    LightUniforms::Light sun;
    sun.Diffuse = { { 1.0, 1.0, 1.0 } };
    sun.Place = Sun;
    sun.ShadowStrength = 1;
    sun.ShadowChannel = 0;
    this->Effects.Lights.Sources = { sun };
    this->Effects.Lights.ShadowSources = { Sun };
    this->Effects.Lights.TwoSided = true;
    this->Effects.Lights.Reach = 4; // through all of it
    this->Marched.Scene.Effects = &this->Effects;
  }

  ReferenceImage render(bool exactLight)
  {
    this->Marched.Scene.Light = exactLight ? LightAt::Points : LightAt::Vertices;
    return renderReference<double>(this->Marched.Scene, this->Level);
  }

  static constexpr std::array<double, 4> Sun{ { 0.6, 0.0, 0.8, 0.0 } };

  EffectData Effects;

private:
  const AccuracyLevel Level;
  MarchedShot Marched;
};

TEST(ShadowedReference, AtVerticesIsNearThatOfEveryPoint)
{
  SunlitShot sunlit(Shot(), DefaultAccuracy);
  const ReferenceImage exact = sunlit.render(true);
  const ReferenceImage atVertices = sunlit.render(false);
  sunlit.Effects.Lights.Sources[0].ShadowStrength = 0;
  sunlit.Effects.Lights.Sources[0].ShadowChannel = -1;
  sunlit.Effects.Lights.ShadowSources.clear();
  const ReferenceImage lit = sunlit.render(false);

  std::cout << "[ MEASURED ] mean red " << meanRed(lit) << ", in shadow " << meanRed(exact)
            << ", at vertices off by RMS " << 255 * rmsBetween(exact, atVertices) << "/255\n";
  EXPECT_GT(meanRed(lit), 0.01);
  EXPECT_LT(meanRed(exact), 0.95 * meanRed(lit));
  EXPECT_GT(meanRed(exact), 0.0);
  // As in the pictures of opaque shadows: the light is interpolated in cells that are not small.
  EXPECT_LE(rmsBetween(exact, atVertices), 4.0 / 255.0);
  EXPECT_GT(rmsBetween(exact, lit), 8.0 / 255.0);
}

// Light at vertices is linear between them.
TEST(ShadowedReference, AtVerticesConverges)
{
  double before = 0;
  for (const int cubes : { 2, 4 })
  {
    Shot shot;
    shot.Data = jitteredLattice(cubes, 0.15, 1, sineField());
    SunlitShot sunlit(shot, GroundTruthAccuracy);
    sunlit.Effects.Lights.ScatteringBlending = 1; // without surfaces
    const double error = rmsBetween(sunlit.render(true), sunlit.render(false));
    std::cout << "[ MEASURED ] " << cubes << " cubes: light at vertices off by RMS " << 255 * error
              << "/255\n";
    EXPECT_TRUE(before == 0 || error < 0.6 * before);
    EXPECT_GT(error, 1.0 / 255.0);
    before = error;
  }
}
} // namespace
