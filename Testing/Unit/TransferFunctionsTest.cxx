// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Functions in the table are those that VTK evaluates.
#include "Optics/TransferFunctions.h"

#include "Optics/FittingTable.h"
#include "Reference/PointKernel.h"
#include "Scalars/StoredScalar.h"

#include "UnitMeshes.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

class TransferFunctions : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Property->SetColor(this->Color);
    this->Property->SetScalarOpacity(this->Opacity);
    this->Color->AddRGBPoint(10.0, 0.1, 0.2, 0.9);
    this->Color->AddRGBPoint(14.0, 0.9, 0.8, 0.1, 0.3, 0.0);
    this->Color->AddRGBPoint(20.0, 0.2, 0.9, 0.2, 0.6, 0.4);
    this->Opacity->AddPoint(11.0, 0.1);
    this->Opacity->AddPoint(15.0, 0.7, 0.3, 0.5);
    this->Opacity->AddPoint(22.0, 0.3);
  }

  std::array<double, 4> byVTK(double s, tetmarch::OpacityLaw law)
  {
    std::array<double, 4> value;
    if (this->Property->GetColorChannels() == 1)
    {
      value.fill(this->Property->GetGrayTransferFunction()->GetValue(s));
    }
    else
    {
      this->Color->GetColor(s, value.data());
    }
    value[3] = extinctionOf(this->Opacity->GetValue(s), law);
    return value;
  }

  // Samples are VTK's values; a table of them gives VTK's value everywhere but for its linear
  // interpolation within a bin and steps that are a bin wide.
  void expectAsVTK(double low, double high, double tolerance)
  {
    for (const auto law : { tetmarch::OpacityLaw::Unstructured, tetmarch::OpacityLaw::Structured })
    {
      const int count = samplesOfTable(1024);
      const SampledFunctions f = sampleFunctions(this->Property, law, low, high, count);
      ASSERT_EQ(f.Samples.size(), static_cast<std::size_t>(count));
      ASSERT_LT(f.Begin, f.End);
      const double bin = (f.End - f.Begin) / (count - 1);
      for (int i = 0; i < count; ++i)
      {
        const auto expected = this->byVTK(f.Begin + i * bin, law);
        for (int k = 0; k < 4; ++k)
        {
          // VTK steps through the samples by its own sum, an ulp or two beside.
          ASSERT_NEAR(f.Samples[i][k], expected[k], 1e-9) << i;
        }
      }
      const IntegralTable table = makeIntegralTable(f);
      const TetMesh none;
      auto kernel = kernelOf<PointKernel<double>, double>(none, table);
      for (int i = 0; i <= 5000; ++i)
      {
        const double share = i / 5000.0;
        const double s = low + share * (high - low);
        const auto value = kernel.tableValue(share * table.scale(high - low) + table.offset(low));
        const auto isNear = [&](double node) { return std::abs(s - node) <= bin; };
        if (!isNear(f.Begin) && !isNear(f.End) && !isNear(11.0) && !isNear(20.0))
        {
          const auto expected = this->byVTK(s, law);
          const double found[4] = { value.x, value.y, value.z, value.w };
          // A colour without extinction is not seen.
          for (int k = expected[3] > 0.0 ? 0 : 3; k < 4; ++k)
          {
            ASSERT_NEAR(found[k], expected[k], tolerance) << s << " " << k;
          }
        }
      }
    }
  }

  vtkNew<vtkVolumeProperty> Property;
  vtkNew<vtkColorTransferFunction> Color;
  vtkNew<vtkPiecewiseFunction> Opacity;
};

TEST_F(TransferFunctions, FirstColourAmongOpacities)
{
  this->Color->RemoveAllPoints();
  this->Color->AddRGBPoint(12.0, 0.2, 0.4, 0.6);
  const auto functions = tetmarch::sampleFunctions(
    this->Property, tetmarch::OpacityLaw::Structured, 11.0, 15.0, 5); // one at the node
  for (const auto& sample : functions.Samples)
  {
    EXPECT_EQ(sample[0], 0.2);
    EXPECT_EQ(sample[2], 0.6);
  }
}

TEST_F(TransferFunctions, WhereTheDataEndBeforeTheNodes) { this->expectAsVTK(12.0, 19.0, 0.02); }

TEST_F(TransferFunctions, WhereTheNodesEndBeforeTheData) { this->expectAsVTK(-100.0, 300.0, 0.02); }

TEST_F(TransferFunctions, WithoutClamping)
{
  this->Color->ClampingOff();
  this->Opacity->ClampingOff();
  this->expectAsVTK(-100.0, 300.0, 0.02);
  const SampledFunctions f =
    sampleFunctions(this->Property, tetmarch::OpacityLaw::Unstructured, -100.0, 300.0, 100);
  EXPECT_EQ(f.Before, (std::array<double, 4>{}));
  EXPECT_EQ(f.After, (std::array<double, 4>{}));
}

TEST_F(TransferFunctions, ColourSpaces)
{
  const std::function<void()> spaces[] = { [this] { this->Color->SetColorSpaceToHSV(); },
    [this] { this->Color->HSVWrapOff(); }, [this] { this->Color->SetColorSpaceToLab(); },
    [this] { this->Color->SetColorSpaceToDiverging(); },
    [this] { this->Color->SetColorSpaceToStep(); } };
  for (const auto& set : spaces)
  {
    set();
    // Hue turns fast: in HSV one bin may change a colour by a step.
    this->expectAsVTK(10.0, 22.0, this->Color->GetColorSpace() == VTK_CTF_STEP ? 1.0 : 0.1);
  }
}

TEST_F(TransferFunctions, LogScale)
{
  this->Color->SetScaleToLog10();
  this->Opacity->UseLogScaleOn();
  this->expectAsVTK(5.0, 30.0, 0.02);
  // Logarithms of what isn't positive are no colours, but no trouble either.
  const SampledFunctions f =
    sampleFunctions(this->Property, tetmarch::OpacityLaw::Unstructured, -5.0, 30.0, 100);
  for (int k = 0; k < 4; ++k)
  {
    EXPECT_TRUE(f.Before[k] >= 0.0 && f.Before[k] <= 1.0);
  }
}

TEST_F(TransferFunctions, GrayChannel)
{
  vtkNew<vtkPiecewiseFunction> gray;
  gray->AddPoint(9.0, 0.2);
  gray->AddPoint(16.0, 0.8, 0.4, 0.6);
  gray->AddPoint(23.0, 0.1);
  this->Property->SetColor(gray);
  ASSERT_EQ(this->Property->GetColorChannels(), 1);
  this->expectAsVTK(0.0, 30.0, 0.02);
}

TEST_F(TransferFunctions, OfWhatIsNotFinite)
{
  using tetmarch::OpacityLaw;
  this->Color->SetNanColorRGBA(0.25, 1.5, -1.0, 0.75);
  EXPECT_EQ(nanColorOf(this->Property, OpacityLaw::Unstructured),
    (std::array<float, 4>{ { 0.25f, 1.0f, 0.0f, 0.75f } }));
  EXPECT_FLOAT_EQ(nanColorOf(this->Property, OpacityLaw::Structured)[3], std::log(4.0f));
  EXPECT_EQ(
    fittingTable(this->Property, OpacityLaw::Unstructured, 0.0, 1.0, DefaultAccuracy).NanColor[3],
    0.75f);
  vtkNew<vtkPiecewiseFunction> gray;
  this->Property->SetColor(gray);
  EXPECT_EQ(nanColorOf(this->Property, OpacityLaw::Unstructured), (std::array<float, 4>{}));
  EXPECT_EQ(this->Property->GetColorChannels(), 1);
}

TEST_F(TransferFunctions, OutOfZeroToOneIsClamped)
{
  this->Color->RemoveAllPoints();
  this->Color->AddRGBPoint(0.0, -1.0, 0.5, 2.0);
  this->Opacity->RemoveAllPoints();
  this->Opacity->AddPoint(0.0, 3.0);
  const SampledFunctions f =
    sampleFunctions(this->Property, tetmarch::OpacityLaw::Unstructured, 0.0, 1.0, 10);
  EXPECT_EQ(f.Samples[5], (std::array<double, 4>{ { 0.0, 0.5, 1.0, 1.0 } }));
}

TEST(OpacityLaws, AsVTKsMappers)
{
  using tetmarch::OpacityLaw;
  EXPECT_EQ(extinctionOf(0.3, OpacityLaw::Unstructured), 0.3);
  EXPECT_EQ(extinctionOf(7.0, OpacityLaw::Unstructured), 1.0);
  EXPECT_EQ(extinctionOf(-1.0, OpacityLaw::Structured), 0.0);
  EXPECT_DOUBLE_EQ(extinctionOf(0.3, OpacityLaw::Structured), -std::log(0.7));
  EXPECT_DOUBLE_EQ(extinctionOf(1e-20, OpacityLaw::Structured), 1e-20);
  EXPECT_DOUBLE_EQ(extinctionOf(1.0, OpacityLaw::Structured), 24.0 * std::log(2.0));
}

// Positions in the table are finite numbers whatever the data and the nodes are, also in float.
TEST_F(TransferFunctions, PositionsAreFiniteForAnyRange)
{
  const double values[] = { 0.0, 1.0, 12.0, 13.0, 1e17, 1e300, 1e36, 4e307, -1e300, -1e17, 1e-300 };
  for (const double low : values)
  {
    for (const double high : values)
    {
      if (low > high)
      {
        continue;
      }
      const ScalarRange range{ low, high };
      const IntegralTable table = makeIntegralTable(sampleFunctions(
        this->Property, tetmarch::OpacityLaw::Unstructured, range.Low, range.High, 60));
      ASSERT_LT(table.Begin, table.End) << low << " " << high;
      for (const float stored : { 0.0f, 0.5f, 1.0f })
      {
        const float x = stored * static_cast<float>(table.scale(range.width())) +
                        static_cast<float>(table.offset(range.Low));
        ASSERT_TRUE(std::isfinite(x)) << low << " " << high;
      }
    }
  }
}

TEST(TransferFunctionsWithoutNodes, AreNothing)
{
  vtkNew<vtkVolumeProperty> property;
  vtkNew<vtkColorTransferFunction> color;
  vtkNew<vtkPiecewiseFunction> opacity;
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
  const SampledFunctions f =
    sampleFunctions(property, tetmarch::OpacityLaw::Unstructured, -5.0, 5.0, 20);
  for (const auto& sample : f.Samples)
  {
    EXPECT_EQ(sample[3], 0.0);
  }
}
} // namespace
