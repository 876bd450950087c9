// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The hard cases as the GL draws them.
#include "Drawing.h"
#include "CaseAccess.h"
#include "CaseViews.h"
#include "PictureCheck.h"

#include "NamedDriver.h"
#include "OffscreenWindow.h"

#include "vtkRenderWindow.h"

#include <cstdlib>
#include <gtest/gtest.h>
#include <regex>
#include <stdexcept>

namespace
{
using namespace tetmarch::testing;

// One for all, of the size that the view wants.
vtkRenderWindow* window(const HardView& view)
{
  static const vtkSmartPointer<vtkRenderWindow> one = []
  {
    std::string error;
    auto made = tetmarch::MakeOffscreenWindow(HardPictureSize, HardPictureSize, &error);
    if (!made)
    {
      throw std::runtime_error(error);
    }
    return made;
  }();
  const int pixels = sizeOf(view);
  one->SetSize(pixels, pixels);
  return one;
}

// Returns the number of rays.
std::int64_t expectRight(const HardCase& hard, const HardView& view)
{
  const Drawn drawn = draw(hard, view, "tetmarch", window(view));
  PictureCheck check(hard, view);
  const PictureResult result = check.compare(drawn.Picture, drawn.Counters, boundsOfGL());
  // What a rasterised entry refuses, the search finds: that is no failure here.
  EXPECT_EQ(result.failures() - drawn.Counters.Refused, 0)
    << view.Name << ": " << result.NotFinite << " not finite, " << result.OutOfBound
    << " out of bound, " << drawn.Counters.Lost << " lost, " << drawn.Counters.Guarded
    << " guarded, worst error " << result.WorstError;
  return drawn.Counters.Rays;
}

class HardDrawing : public ::testing::TestWithParam<std::string>
{
};

// One view of each case if TETMARCH_FIRST_VIEWS is set, for the tests of pages.
TEST_P(HardDrawing, ByTheGLIsRight)
{
  const HardCase& hard = caseOf(GetParam());
  for (const HardView& view : viewsOf(hard))
  {
    if (!view.ReferenceOnly)
    {
      expectRight(hard, view);
      if (std::getenv("TETMARCH_FIRST_VIEWS") != nullptr)
      {
        break;
      }
    }
  }
}

std::string testNameOf(const ::testing::TestParamInfo<std::string>& tested)
{
  return std::regex_replace(tested.param, std::regex("[^A-Za-z0-9]"), "_");
}

INSTANTIATE_TEST_SUITE_P(Case, HardDrawing, ::testing::ValuesIn(hardCaseNames()), testNameOf);

// The same in small windows by the driver that GALLIUM_DRIVER names, which may be slow. Cases with
// the camera inside, and those with too many boundary faces for its buffers, are left out: softpipe
// draws neither.
class SmallHardDrawing : public ::testing::TestWithParam<std::string>
{
protected:
  void SetUp() override
  {
    static const std::string instead = whatServesInstead();
    if (!instead.empty())
    {
      GTEST_SKIP() << instead;
    }
  }
};

constexpr int SmallSize = 17;

TEST_P(SmallHardDrawing, IsRight)
{
  const HardCase& hard = caseOf(GetParam());
  std::int64_t rays = 0;
  for (const HardView& view : viewsOf(hard))
  {
    if (!view.ReferenceOnly)
    {
      rays += expectRight(hard, inSmallWindow(view, SmallSize));
    }
  }
  EXPECT_GT(rays, 100); // of up to 12 views
}

INSTANTIATE_TEST_SUITE_P(Rays, SmallHardDrawing,
  ::testing::Values("pixels-on-vertices", "pixels-on-edges", "jumps", "fan-through-vertices",
    "rays-parallel-to-faces"),
  testNameOf);
INSTANTIATE_TEST_SUITE_P(Cells, SmallHardDrawing,
  ::testing::Values("squashed-1e-3", "squashed-1e-8", "needle-fan", "flat-inside",
    "flat-on-boundary", "edges-without-length", "repeated-points", "tangled-inside", "tangled",
    "crack", "two-equal-meshes", "cubes-side-by-side", "overlap-of-one-ulp", "gap-of-one-float-ulp",
    "hanging-nodes-bulging", "faces-of-three", "moebius", "common-vertex"),
  testNameOf);
INSTANTIATE_TEST_SUITE_P(Scale, SmallHardDrawing,
  ::testing::Values("scaled-1e-12", "scaled-1e12", "offset-1e6", "offset-1e9", "offset-1e4-float",
    "camera-at-1e6", "matrix-stretching-by-1e6", "plate", "rod"),
  testNameOf);
INSTANTIATE_TEST_SUITE_P(Optics, SmallHardDrawing,
  ::testing::Values("nan-at-some-points", "nan-in-some-cells", "values-times-1e300", "outlier",
    "cells-int", "steps", "spikes-of-one-entry", "spikes-without-width", "opacity-1",
    "unit-distance-1e-9-with-gaps"),
  testNameOf);
INSTANTIATE_TEST_SUITE_P(NonConvex, SmallHardDrawing,
  ::testing::Values("torus", "nested-shells", "cavity", "spiral", "sheets", "touching-in-face",
    "touching-in-edge", "touching-in-vertex", "overlapping", "one-in-another"),
  testNameOf);
} // namespace
