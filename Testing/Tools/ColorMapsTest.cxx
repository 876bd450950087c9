// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ColorMaps.h"
#include "Failure.h"

#include "vtkColorTransferFunction.h"
#include "vtkMath.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
/// CIE L*, from 0 (black) to 100 (white), at a share of the range 0 to 1.
double GetLightness(vtkColorTransferFunction* color, double share)
{
  double rgb[3];
  double lab[3];
  color->GetColor(share, rgb);
  vtkMath::RGBToLab(rgb, lab);
  return lab[0];
}

/// How many of a hundred steps from first to last make the colour darker.
int CountDarkerSteps(vtkColorTransferFunction* color, double first, double last)
{
  int darker = 0;
  for (int i = 0; i < 100; ++i)
  {
    const double here = first + (last - first) * i / 100.0;
    const double next = first + (last - first) * (i + 1) / 100.0;
    darker += GetLightness(color, next) < GetLightness(color, here);
  }
  return darker;
}
} // namespace

TEST(ColorMaps, Names)
{
  const auto names = tetmarch::GetColorMapNames();
  EXPECT_EQ(names, (std::vector<std::string>{ "Viridis", "Plasma", "Inferno", "Magma", "Cividis",
                     "Cool to Warm", "Black-Body Radiation", "X Ray" }));
}

TEST(ColorMaps, SequentialOnesAreMonotoneInLightness)
{
  for (const std::string& name : tetmarch::GetColorMapNames())
  {
    vtkNew<vtkColorTransferFunction> color;
    ASSERT_TRUE(tetmarch::ApplyColorMap(name, 0.0, 1.0, color));
    if (name == "Cool to Warm") // lightest in the middle
    {
      EXPECT_EQ(CountDarkerSteps(color, 0.0, 0.5), 0);
      EXPECT_EQ(CountDarkerSteps(color, 0.5, 1.0), 100);
      EXPECT_GT(GetLightness(color, 0.5), 80.0);
      EXPECT_NEAR(GetLightness(color, 0.0), GetLightness(color, 1.0), 6.0);
    }
    else
    {
      EXPECT_EQ(CountDarkerSteps(color, 0.0, 1.0), name == "X Ray" ? 100 : 0) << name;
      EXPECT_GT(std::abs(GetLightness(color, 1.0) - GetLightness(color, 0.0)), 60.0) << name;
    }
  }
}

TEST(ColorMaps, SpanTheRange)
{
  for (const std::string& name : tetmarch::GetColorMapNames())
  {
    vtkNew<vtkColorTransferFunction> unit;
    vtkNew<vtkColorTransferFunction> color;
    color->AddRGBPoint(1e6, 1.0, 1.0, 1.0);
    ASSERT_TRUE(tetmarch::ApplyColorMap(name, 0.0, 1.0, unit));
    ASSERT_TRUE(tetmarch::ApplyColorMap(name, 317.1, -12.3, color)); // either end first
    EXPECT_EQ(color->GetRange()[0], -12.3) << name;
    EXPECT_EQ(color->GetRange()[1], 317.1) << name;
    EXPECT_NEAR(
      color->GetGreenValue(-12.3 + 0.375 * (317.1 + 12.3)), unit->GetGreenValue(0.375), 1e-9)
      << name;
  }
}

TEST(ColorMaps, RangeWithoutWidthHasTheColorOfTheMiddle)
{
  vtkNew<vtkColorTransferFunction> color;
  ASSERT_TRUE(tetmarch::ApplyColorMap("X Ray", 3.0, 3.0, color));
  EXPECT_EQ(color->GetSize(), 1);
  EXPECT_DOUBLE_EQ(color->GetRedValue(3.0), 0.5);
}

TEST(ColorMaps, LogarithmicScaleIsKeptAboveZero)
{
  vtkNew<vtkColorTransferFunction> color;
  color->SetScaleToLog10();
  ASSERT_TRUE(tetmarch::ApplyColorMap("Black-Body Radiation", 1.0, 1e5, color));
  EXPECT_EQ(color->GetScale(), VTK_CTF_LOG10);
  EXPECT_NEAR(color->GetRedValue(100.0), 230.0 / 255.0, 1e-6); // the map's point at 0.4
  EXPECT_NEAR(color->GetGreenValue(100.0), 0.0, 1e-6);
  ASSERT_TRUE(tetmarch::ApplyColorMap("Black-Body Radiation", 0.0, 1e5, color));
  EXPECT_EQ(color->GetScale(), VTK_CTF_LINEAR);
}

TEST(ColorMaps, CaseBlanksAndMatplotlibDoNotCount)
{
  for (const char* const name : { "Inferno (matplotlib)", "INFERNO", " inferno" })
  {
    vtkNew<vtkColorTransferFunction> color;
    EXPECT_TRUE(tetmarch::ApplyColorMap(name, 0.0, 1.0, color)) << name;
    EXPECT_NEAR(color->GetRedValue(1.0), 0.988362, 1e-6) << name;
  }
  vtkNew<vtkColorTransferFunction> color;
  EXPECT_TRUE(tetmarch::ApplyColorMap("CoolToWarm", 0.0, 1.0, color));
  EXPECT_TRUE(tetmarch::ApplyColorMap("xray", 0.0, 1.0, color));
}

TEST(ColorMaps, UnknownNameLeavesTheFunctionAndIsAnsweredByTheList)
{
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(2.0, 0.25, 0.5, 0.75);
  for (const char* const name : { "Rainbow", "", "Infern", "Inferno2" })
  {
    EXPECT_FALSE(tetmarch::ApplyColorMap(name, 0.0, 1.0, color)) << name;
    EXPECT_EQ(color->GetSize(), 1);
    EXPECT_EQ(color->GetBlueValue(2.0), 0.75);
  }
  EXPECT_EQ(tetmarch::DescribeUnknownColorMap("Rainbow"),
    "there is no colour map 'Rainbow'; known are Viridis, Plasma, Inferno, Magma, Cividis, "
    "Cool to Warm, Black-Body Radiation, X Ray");
}

TEST(ColorMaps, RangeMustBeFinite)
{
  vtkNew<vtkColorTransferFunction> color;
  EXPECT_THROW(tetmarch::ApplyColorMap("Viridis", 0.0, std::nan(""), color), tetmarch::Failure);
  EXPECT_THROW(tetmarch::ApplyColorMap("Viridis", -HUGE_VAL, 1.0, color), tetmarch::Failure);
}
