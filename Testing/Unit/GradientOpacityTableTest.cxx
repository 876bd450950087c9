// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Factors of gradient opacity in the table are those that VTK evaluates.
#include "Optics/GradientOpacityTable.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVersionMacros.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace
{
using namespace tetmarch;

constexpr int Steps = GradientOpacityTable::Steps;

class GradientOpacity : public ::testing::Test
{
protected:
  void SetUp() override { this->Property->SetGradientOpacity(this->Function); }

  GradientOpacityTable table(double mostMagnitude)
  {
    return gradientOpacityOf(this->Property, mostMagnitude);
  }

  // Samples up to `range` are VTK's values.
  void expectAsVTK(const GradientOpacityTable& table, double range)
  {
    ASSERT_EQ(table.Values.size(), static_cast<std::size_t>(Steps + 1));
    EXPECT_DOUBLE_EQ(table.Unit, range / Steps);
    for (int i = 0; i <= Steps; ++i)
    {
      EXPECT_NEAR(table.Values[i], this->Function->GetValue(i * table.Unit), 1e-6) << i;
    }
  }

  void expectConstant(const GradientOpacityTable& table, float value)
  {
    EXPECT_EQ(table.Values, std::vector<float>(Steps + 1, value));
    EXPECT_GT(table.Unit, 0.0);
    EXPECT_TRUE(std::isfinite(table.Unit));
  }

  vtkNew<vtkVolumeProperty> Property;
  vtkNew<vtkPiecewiseFunction> Function;
};

TEST_F(GradientOpacity, EndsWithTheDataOrTheNodes)
{
  this->Function->AddPoint(0.0, 0.2);
  this->Function->AddPoint(16.0, 0.9, 0.25, 0.0);
  this->Function->AddPoint(64.0, 0.1, 0.5, 0.0);
  this->expectAsVTK(this->table(1000.0), 64.0);
  this->expectAsVTK(this->table(64.0), 64.0);
  this->expectAsVTK(this->table(32.0), 32.0);
  this->expectAsVTK(this->table(8.0), 8.0);
  EXPECT_EQ(this->table(1000.0).Values.back(), 0.1f); // which holds beyond
}

TEST_F(GradientOpacity, MidpointAndSharpness)
{
  this->Function->AddPoint(0.0, 0.0, 0.3, 0.6);
  this->Function->AddPoint(32.0, 1.0, 0.8, 0.2);
  this->Function->AddPoint(64.0, 0.3);
  this->expectAsVTK(this->table(100.0), 64.0);
}

TEST_F(GradientOpacity, LogScale)
{
  this->Function->UseLogScaleOn();
  this->Function->AddPoint(1.0, 0.0);
  this->Function->AddPoint(64.0, 1.0);
  this->expectAsVTK(this->table(100.0), 64.0);
}

TEST_F(GradientOpacity, OffIsEmpty)
{
  EXPECT_TRUE(gradientOpacityOf(vtkNew<vtkVolumeProperty>(), 10.0).empty());
  this->Function->AddPoint(0.0, 0.2);
  this->Function->AddPoint(10.0, 0.9);
  EXPECT_FALSE(this->table(10.0).empty());
  this->Property->DisableGradientOpacityOn();
  EXPECT_TRUE(this->table(10.0).empty());
  this->Property->DisableGradientOpacityOff();
  EXPECT_FALSE(this->table(10.0).empty());
  vtkNew<vtkImageData> ofTwo;
  ofTwo->SetDimensions(2, 2, 1);
  ofTwo->AllocateScalars(VTK_FLOAT, 4);
  this->Property->SetTransferFunction2D(ofTwo);
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
  this->Property->SetTransferFunctionModeTo2D(); // which VTK 9.1 does by itself
#endif
  EXPECT_TRUE(this->table(10.0).empty());
}

// Asking changes nothing: what was made from the property would be made again.
TEST_F(GradientOpacity, PropertyStaysAsItIs)
{
  vtkNew<vtkVolumeProperty> property;
  const vtkMTimeType before = property->GetMTime();
  gradientOpacityOf(property, 10.0);
  EXPECT_FALSE(property->HasGradientOpacity());
  EXPECT_EQ(property->GetMTime(), before);
}

TEST_F(GradientOpacity, OneForAllOfTheDataIsEmpty)
{
  this->Function->AddPoint(0.0, 1.0);
  this->Function->AddPoint(7.0, 1.5);
  this->Function->AddPoint(13.7, 1.0);
  this->Function->AddPoint(20.0, 0.0);
  for (const double most : { 0.0, 1.0, 7.3, 13.0, 13.7 })
  {
    EXPECT_TRUE(this->table(most).empty()) << most;
  }
  EXPECT_FALSE(this->table(13.8).empty());
  EXPECT_FALSE(this->table(1e300).empty());
}

TEST_F(GradientOpacity, NodesOutsideOfTheRange)
{
  this->Function->AddPoint(-10.0, 0.0);
  this->Function->AddPoint(10.0, 1.0);
  this->expectAsVTK(this->table(5.0), 5.0);
  EXPECT_EQ(this->table(5.0).Values.front(), 0.5f);

  this->Function->RemoveAllPoints();
  this->Function->AddPoint(50.0, 0.4);
  this->Function->AddPoint(60.0, 1.0);
  this->expectAsVTK(this->table(10.0), 10.0);

  this->Function->RemoveAllPoints();
  this->Function->AddPoint(-60.0, 0.4);
  this->Function->AddPoint(-50.0, 0.25);
  this->expectConstant(this->table(10.0), 0.25f);
}

TEST_F(GradientOpacity, FewNodes)
{
  this->expectConstant(this->table(10.0), 0.0f); // as VTK says
  this->Function->AddPoint(5.0, 0.5);
  this->expectConstant(this->table(10.0), 0.5f);
  this->Function->AddPoint(5.0, 1.0);
  EXPECT_TRUE(this->table(10.0).empty());
}

TEST_F(GradientOpacity, OutOfZeroToOneIsClamped)
{
  this->Function->AddPoint(0.0, -1.0);
  this->Function->AddPoint(8.0, 3.0);
  const auto values = this->table(10.0).Values;
  EXPECT_EQ(values.front(), 0.0f);
  EXPECT_EQ(values[Steps / 4], 0.0f);
  EXPECT_NEAR(values[Steps * 3 / 8], 0.5f, 1e-6f);
  EXPECT_EQ(values[Steps / 2], 1.0f);
  EXPECT_EQ(values.back(), 1.0f);
}

// Then beyond its nodes a function is 0.
TEST_F(GradientOpacity, WithoutClamping)
{
  this->Function->ClampingOff();
  this->Function->AddPoint(2.0, 1.0);
  this->Function->AddPoint(10.0, 1.0);
  const GradientOpacityTable table = this->table(100.0);
  EXPECT_EQ(table.Values.front(), 0.0f);
  EXPECT_EQ(table.Values[Steps / 2], 1.0f);
  EXPECT_EQ(table.Values[Steps - 2], 1.0f);
  EXPECT_EQ(table.Values.back(), 0.0f);
  EXPECT_NEAR((Steps - 1) * table.Unit, 10.0, 1e-12);
  this->expectAsVTK(this->table(5.0), 5.0);
}

void expectRampAtMiddle(const GradientOpacityTable& table)
{
  for (int i = 0; i <= Steps; ++i)
  {
    const double x = i * table.Unit;
    if (std::abs(x - 4.5) > table.Unit)
    {
      ASSERT_EQ(table.Values[i], x < 4.5 ? 0.0f : 1.0f) << i;
    }
  }
}

TEST_F(GradientOpacity, JumpsAreNarrowRamps)
{
  this->Function->AddPoint(0.0, 0.0);
  this->Function->AddPoint(4.5, 0.0);
  this->Function->AddPoint(std::nextafter(4.5, 5.0), 1.0);
  this->Function->AddPoint(10.0, 1.0);
  expectRampAtMiddle(this->table(10.0));
}

TEST_F(GradientOpacity, JumpsOfSharpnessAreNarrowRamps)
{
  this->Function->AddPoint(0.0, 0.0, 0.5, 1.0);
  this->Function->AddPoint(9.0, 1.0);
  this->Function->AddPoint(10.0, 1.0);
  if (this->Function->GetValue(4.4) > 0.0)
  {
    GTEST_SKIP() << "this VTK makes a curve of a sharpness of 1, as 9.6 does";
  }
  expectRampAtMiddle(this->table(10.0));
}

// Peaks and gaps of which no sample knows, wherever in their step they are.
TEST_F(GradientOpacity, NarrowPeaksAreKept)
{
  const double unit = 10.0 / Steps;
  for (const float peak : { 0.0f, 1.0f })
  {
    for (const double place : { 0.3, 0.7, 100.1, 511.5, 512.9, 1023.2, 1023.8 })
    {
      const double x = place * unit;
      this->Function->RemoveAllPoints();
      this->Function->AddPoint(0.0, 1.0f - peak);
      this->Function->AddPoint(x - 0.01 * unit, 1.0f - peak);
      this->Function->AddPoint(x, peak);
      this->Function->AddPoint(x + 0.01 * unit, 1.0f - peak);
      this->Function->AddPoint(10.0, 1.0f - peak);
      const std::vector<float> values = this->table(10.0).Values;
      ASSERT_EQ(values.size(), static_cast<std::size_t>(Steps + 1));
      EXPECT_EQ(std::count(values.begin(), values.end(), peak), 1) << place;
      const auto found = std::find(values.begin(), values.end(), peak) - values.begin();
      EXPECT_LE(std::abs(static_cast<double>(found) - place), 1.0) << place;
      // Of magnitudes that many cells may have.
      EXPECT_EQ(values.front(), 1.0f - peak);
      EXPECT_EQ(values.back(), 1.0f - peak);
    }
  }
}

// Of several between the same two steps that which stands out most.
TEST_F(GradientOpacity, HighestPeakIsKept)
{
  const double unit = 10.0 / Steps;
  const double nodes[][2] = { { 0.0, 0.0 }, { 200.05, 0.0 }, { 200.1, 0.6 }, { 200.2, 0.9 },
    { 200.25, 0.4 }, { 200.3, 0.0 }, { Steps, 0.0 } };
  for (const auto& node : nodes)
  {
    this->Function->AddPoint(node[0] * unit, node[1]);
  }
  const std::vector<float> values = this->table(10.0).Values;
  EXPECT_EQ(values[200], 0.9f);
  EXPECT_EQ(std::count(values.begin(), values.end(), 0.0f), Steps);
}

TEST_F(GradientOpacity, AnyMostMagnitude)
{
  constexpr double inf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  this->Function->AddPoint(0.0, 0.25);
  this->Function->AddPoint(64.0, 1.0);
  for (const double notFinite : { inf, nan, -inf })
  {
    this->expectAsVTK(this->table(notFinite), 64.0);
  }
  for (const double none : { 0.0, -5.0, 5e-324 })
  {
    this->expectConstant(this->table(none), 0.25f);
  }
  this->expectAsVTK(this->table(1e-200), 1e-200);
}
} // namespace
