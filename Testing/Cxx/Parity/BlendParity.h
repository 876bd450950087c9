// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What the GL draws in each blend mode, pixel by pixel against the CPU reference
 */
#ifndef tetmarch_testing_BlendParity_h
#define tetmarch_testing_BlendParity_h

#include "BlendScene.h"
#include "CpuReference.h"
#include "ScenePage.h"

#include <gtest/gtest.h>
#include <iostream>

namespace tetmarch::testing
{
/// What shows scalars where they jump, or surfaces, has edges inside the silhouette, where rounding
/// decides which side a pixel sees.
constexpr std::size_t PixelsAnEdgeCosts = 250; // one of so many

/// The picture against the reference's, behind opaque geometry, too, and where nothing is.
inline void expectBlendModeParity(Scene& scene)
{
  const Image drawn = scene.render();
  const std::vector<float> depths = scene.windowDepths();
  const ReferencePicture reference = referenceOf(scene, depths);
  const Regions regions = regionsOf(scene, depths);
  const Difference inside = compare(drawn, reference.Picture, regions.Inside);
  std::cout << "[ MEASURED ] " << scene.Mapper->GetBlendModeAsString() << ": " << inside.text()
            << '\n';
  EXPECT_GT(inside.Pixels, 400u);
  EXPECT_LE(inside.Over * PixelsAnEdgeCosts, inside.Pixels)
    << scene.Mapper->GetBlendModeAsString() << ": " << inside.text();
  EXPECT_LE(inside.Percentile999, 8.0 / 255.0) << inside.text();
  const Image nothing(drawn.Width, drawn.Height);
  EXPECT_EQ(compare(drawn, nothing, regions.Outside, 0.0).Over, 0u) << "something outside";
  EXPECT_GT(compare(drawn, nothing, regions.Inside).Max, 0.1) << "nothing inside";
  EXPECT_EQ(scene.Mapper->GetNumberOfLostRays(), 0);
  EXPECT_EQ(scene.Mapper->GetNumberOfGuardHits(), 0);
  keepScenePage(scene.Window);
}

inline void expectBlendParity(Scene& scene)
{
  for (const int mode : BlendModes)
  {
    scene.Mapper->SetBlendMode(mode);
    expectBlendModeParity(scene);
  }
}
} // namespace tetmarch::testing

#endif
