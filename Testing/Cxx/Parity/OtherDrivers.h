// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Tiny pictures by the driver of Mesa that GALLIUM_DRIVER names, beside the CPU reference
 */
#ifndef tetmarch_testing_OtherDrivers_h
#define tetmarch_testing_OtherDrivers_h

#include "CpuReference.h"
#include "NamedDriver.h"

#include <gtest/gtest.h>
#include <iostream>

namespace tetmarch::testing
{
/// Skipped where Mesa lacks the driver.
class OtherDrivers : public ::testing::Test
{
protected:
  static constexpr int Side = 24; // of the window, in pixels

  void SetUp() override
  {
    const std::string instead = whatServesInstead();
    if (!instead.empty())
    {
      GTEST_SKIP() << instead;
    }
  }
  static bool isSoftpipe() { return namedDriver() == "softpipe"; }

  /// Edges: one pixel in pixelsOfEdge may be another's.
  static void expectReference(
    Scene& scene, const std::string& what, std::size_t pixelsOfEdge = Side * Side)
  {
    const Image drawn = scene.render();
    const Regions regions = regionsOf(scene);
    const Difference inside = compare(drawn, referenceOf(scene).Picture, regions.Inside);
    std::cout << "[ MEASURED ] " << what << ": " << inside.text() << '\n';
    EXPECT_GT(inside.Pixels, 100u) << what;
    EXPECT_LE(inside.Over * pixelsOfEdge, inside.Pixels) << what << ": " << inside.text();
    const Image nothing(drawn.Width, drawn.Height);
    EXPECT_GT(compare(drawn, nothing, regions.Inside).Max, 0.05) << what << ": nothing inside";
    EXPECT_EQ(compare(drawn, nothing, regions.Outside, 0.0).Over, 0u) << what;
    EXPECT_EQ(scene.Mapper->GetNumberOfLostRays() + scene.Mapper->GetNumberOfGuardHits(), 0)
      << what;
  }
};
} // namespace tetmarch::testing

#endif
