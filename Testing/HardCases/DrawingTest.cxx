// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The hard cases as the GL draws them.
#include "Drawing.h"
#include "PictureCheck.h"

#include "OffscreenWindow.h"

#include "vtkRenderWindow.h"

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

class HardDrawing : public ::testing::TestWithParam<std::string>
{
};

TEST_P(HardDrawing, ByTheGLIsRight)
{
  const HardCase& hard = *findHardCase(GetParam());
  for (const HardView& view : viewsOf(hard))
  {
    if (view.ReferenceOnly)
    {
      continue;
    }
    const Drawn drawn = draw(hard, view, "tetmarch", window(view));
    PictureCheck check(hard, view);
    const PictureResult result = check.compare(drawn.Picture, drawn.Counters, boundsOfGL());
    // What a rasterised entry refuses, the search finds: that is no failure here.
    EXPECT_EQ(result.failures() - drawn.Counters.Refused, 0)
      << view.Name << ": " << result.NotFinite << " not finite, " << result.OutOfBound
      << " out of bound, " << drawn.Counters.Lost << " lost, " << drawn.Counters.Guarded
      << " guarded, worst error " << result.WorstError;
  }
}

INSTANTIATE_TEST_SUITE_P(Case, HardDrawing, ::testing::ValuesIn(hardCaseNames()),
  [](const ::testing::TestParamInfo<std::string>& tested)
  { return std::regex_replace(tested.param, std::regex("[^A-Za-z0-9]"), "_"); });
} // namespace
