// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The options of blend modes: which are errors, and the tables and variants that others need.
#include "Appearance/Blending.h"
#include "Light/EffectOptions.h"
#include "Scalars/StoredScalar.h"
#include "Variants/VariantKey.h"

#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <gtest/gtest.h>
#include <limits>
#include <numeric>

namespace
{
using namespace tetmarch;

class BlendingTest : public ::testing::Test
{
protected:
  BlendingTest()
  {
    vtkNew<vtkColorTransferFunction> color;
    color->AddRGBPoint(10.0, 0.0, 0.5, 1.0);
    color->AddRGBPoint(30.0, 1.0, 0.5, 0.0);
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(10.0, 0.0);
    opacity->AddPoint(30.0, 0.8);
    this->Property->SetColor(color);
    this->Property->SetScalarOpacity(opacity);
  }

  std::string make(BlendMode mode, std::array<double, 2> range = { { -1e38, 1e38 } })
  {
    return makeBlending({ static_cast<int>(mode), range }, this->Property, this->Range, this->Made);
  }
  void setValues(const std::vector<double>& values)
  {
    vtkContourValues* contours = this->Property->GetIsoSurfaceValues();
    contours->SetNumberOfContours(static_cast<int>(values.size()));
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      contours->SetValue(static_cast<int>(i), values[i]);
    }
  }

  vtkNew<vtkVolumeProperty> Property;
  ScalarRange Range{ 10.0, 30.0 };
  Blending Made;
};

TEST_F(BlendingTest, UnknownModesAreErrors)
{
  for (const int mode : { -1, 6, 1000 })
  {
    const std::string error = makeBlending({ mode, {} }, this->Property, this->Range, this->Made);
    EXPECT_NE(error.find(std::to_string(mode)), std::string::npos) << error;
    EXPECT_NE(error.find("isosurface (5)"), std::string::npos) << error;
  }
  for (int mode = 0; mode < 6; ++mode)
  {
    EXPECT_EQ(makeBlending({ mode, {} }, this->Property, this->Range, this->Made), "");
    EXPECT_EQ(static_cast<int>(this->Made.Mode), mode);
  }
}

TEST_F(BlendingTest, SurfacesAscendAndComeOnce)
{
  this->setValues(
    { 25.0, std::nan(""), 15.0, 25.0, std::numeric_limits<double>::infinity(), 20.0 });
  EXPECT_EQ(this->make(BlendMode::IsoSurface), "");
  EXPECT_EQ(this->Made.IsoValues, (std::vector<float>{ 0.25f, 0.5f, 0.75f }));
  ASSERT_EQ(this->Made.IsoColors.size(), 3u);
  const std::array<float, 4> expected{ { 0.75f, 0.5f, 0.25f, 0.6f } };
  for (int k = 0; k < 4; ++k)
  {
    EXPECT_NEAR(this->Made.IsoColors[2][k], expected[k], 1e-6f);
  }
  EXPECT_EQ(this->make(BlendMode::Maximum), "");
  EXPECT_TRUE(this->Made.IsoValues.empty());
}

TEST_F(BlendingTest, TooManySurfacesAreAnError)
{
  std::vector<double> values(MostIsoSurfaces);
  std::iota(values.begin(), values.end(), 1.0);
  this->setValues(values);
  EXPECT_EQ(this->make(BlendMode::IsoSurface), "");
  values.push_back(17.5);
  this->setValues(values);
  const std::string error = this->make(BlendMode::IsoSurface);
  EXPECT_NE(error.find("33"), std::string::npos) << error;
  EXPECT_NE(error.find("32"), std::string::npos) << error;
  EXPECT_EQ(this->make(BlendMode::Maximum), "");
}

TEST_F(BlendingTest, RangesAreOfAveragesAlone)
{
  EXPECT_EQ(this->make(BlendMode::Average, { { 15.0, 20.0 } }), "");
  EXPECT_EQ(this->Made.AverageRange, (std::array<float, 2>{ { 0.25f, 0.5f } }));
  this->make(BlendMode::Average, { { -1e38, 1e38 } });
  EXPECT_EQ(this->Made.AverageRange, (std::array<float, 2>{ { -1.0f, 2.0f } }));
  this->make(BlendMode::Average, { { 20.0, 15.0 } });
  EXPECT_GT(this->Made.AverageRange[0], 2.0f);
  this->make(BlendMode::Additive, { { 15.0, 20.0 } });
  EXPECT_EQ(this->Made.AverageRange, (std::array<float, 2>{ { -1.0f, 2.0f } }));
}

TEST_F(BlendingTest, VersionsTellWhatIsShown)
{
  this->setValues({ 20.0 });
  this->make(BlendMode::IsoSurface);
  const Fingerprint before = versionOf(this->Made);
  this->make(BlendMode::IsoSurface);
  EXPECT_EQ(versionOf(this->Made), before);
  this->setValues({ 21.0 });
  this->make(BlendMode::IsoSurface);
  EXPECT_NE(versionOf(this->Made), before);
}

TEST_F(BlendingTest, ModesOfAKindShareAVariant)
{
  const auto groupOf = [this](BlendMode mode)
  {
    this->make(mode);
    VariantKey key;
    this->Made.setBits(key);
    return key.Blend;
  };
  EXPECT_EQ(groupOf(BlendMode::Composite), BlendGroup::Composite);
  EXPECT_EQ(groupOf(BlendMode::Maximum), BlendGroup::Extreme);
  EXPECT_EQ(groupOf(BlendMode::Minimum), BlendGroup::Extreme);
  EXPECT_EQ(groupOf(BlendMode::Average), BlendGroup::Sum);
  EXPECT_EQ(groupOf(BlendMode::Additive), BlendGroup::Sum);
  EXPECT_EQ(groupOf(BlendMode::IsoSurface), BlendGroup::Isosurfaces);
}

// The table has the opacity as it is, whatever the law, and for sums the intensity as the colour.
TEST_F(BlendingTest, TablesHaveOpacityAndIntensity)
{
  const auto valueAt = [](const IntegralTable& table, double scalar)
  {
    const double x = (scalar - 10.0) / 20.0 * table.scale(20.0) + table.offset(10.0);
    const auto entry = static_cast<std::size_t>(x);
    const double share = x - static_cast<double>(entry);
    std::array<double, 4> value{};
    for (int k = 0; k < 4; ++k)
    {
      value[k] =
        double(table.Values[entry][k]) * (1 - share) + double(table.Values[entry + 1][k]) * share;
    }
    return value;
  };
  const auto tableOf = [&](BlendMode mode)
  {
    this->make(mode);
    return blendedTable(
      this->Property, OpacityLaw::Structured, this->Made, this->Range, DefaultAccuracy);
  };
  const auto maximum = valueAt(tableOf(BlendMode::Maximum), 25.0);
  EXPECT_NEAR(maximum[0], 0.75, 1e-4);
  EXPECT_NEAR(maximum[3], 0.6, 1e-4);
  const auto sum = valueAt(tableOf(BlendMode::Additive), 25.0);
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_NEAR(sum[k], 0.75, 1e-4);
  }
  EXPECT_NEAR(sum[3], 0.6, 1e-4);
  const auto composite = valueAt(tableOf(BlendMode::Composite), 25.0);
  EXPECT_NEAR(composite[3], -std::log(0.4), 2e-3);
}

TEST(BlendedEffects, OnlyWhatAModeShows)
{
  EffectOptions options;
  options.Shadows = ShadowMethod::AtVertices;
  options.Scattering = 1;
  options.Occlusion = true;
  options.OpaqueShadows = true;
  options.Shown = Subject::Gradients;
  EffectOptions used = usedOptions(options);
  EXPECT_TRUE(used.Occlusion && used.OpaqueShadows && used.Scattering == 1);
  EXPECT_EQ(used.Shadows, ShadowMethod::AtVertices);
  options.Blend = BlendMode::IsoSurface;
  used = usedOptions(options);
  EXPECT_FALSE(used.Occlusion || used.OpaqueShadows || used.Scattering > 0);
  EXPECT_EQ(used.Shadows, ShadowMethod::Off);
  EXPECT_EQ(used.Shown, Subject::Gradients);
  EXPECT_TRUE(used.showsSurfaces());
  options.Blend = BlendMode::Additive;
  used = usedOptions(options);
  EXPECT_EQ(used.Shown, Subject::Picture);
  EXPECT_FALSE(used.showsSurfaces());
}
} // namespace
