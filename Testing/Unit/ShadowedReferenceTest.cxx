// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Shadows that the volume casts in itself, in pictures of the CPU reference: kept at vertices they
// are near those that are marched wherever a ray crosses a face.
#include "Light/EffectData.h"
#include "Mesh/Gradients.h"
#include "Mesh/VertexStarts.h"

#include "Images.h"
#include "Shot.h"

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

TEST(ShadowedReference, AtVerticesIsNearMarchedEverywhere)
{
  const Shot shot;
  MarchedShot marched(shot, DefaultAccuracy);
  EffectData effects;
  effects.Gradients = vertexGradients(marched.Mesh);
  effects.VertexStarts = vertexStarts(marched.Mesh);
  LightUniforms::Light sun;
  sun.Diffuse = { { 1.0, 1.0, 1.0 } };
  sun.Place = { { 0.6, 0.0, 0.8, 0.0 } };
  effects.Lights.Sources = { sun };
  effects.Lights.TwoSided = true;
  effects.Lights.Reach = 2;
  marched.Scene.Effects = &effects;
  const ReferenceImage lit = renderReference<double>(marched.Scene, DefaultAccuracy);

  effects.Lights.Sources[0].ShadowStrength = 1;
  effects.Lights.Sources[0].ShadowChannel = 0;
  effects.Lights.ShadowSources = { sun.Place };
  marched.Scene.ExactLight = true;
  const ReferenceImage exact = renderReference<double>(marched.Scene, DefaultAccuracy);
  marched.Scene.ExactLight = false;
  const ReferenceImage atVertices = renderReference<double>(marched.Scene, DefaultAccuracy);

  std::cout << "[ MEASURED ] mean red " << meanRed(lit) << ", in shadow " << meanRed(exact)
            << ", at vertices off by RMS " << 255 * rmsBetween(exact, atVertices) << "/255\n";
  EXPECT_GT(meanRed(lit), 0.01);
  EXPECT_LT(meanRed(exact), 0.95 * meanRed(lit));
  EXPECT_GT(meanRed(exact), 0.0);
  // As in the pictures of opaque shadows: the light is interpolated in cells that are not small.
  EXPECT_LE(rmsBetween(exact, atVertices), 4.0 / 255.0);
  EXPECT_GT(rmsBetween(exact, lit), 8.0 / 255.0);
}
} // namespace
