// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The tables of the transfer functions are made once for what they depend on, whatever is drawn by
// them.
#include "Appearance/TransferTables.h"

#include "ComponentFields.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

class Tables : public ::testing::Test
{
protected:
  Tables()
  {
    setComponentFunctions(this->Property, 3);
    this->Input.Blend = &this->Blend;
    this->Input.Range = { 0, 1 };
  }

  void drawThree()
  {
    this->Input.Mix = ComponentMix::Independent;
    this->Input.ExtraRanges = { { 0, 1 }, { 0, 2 } };
  }

  // So often in all after one more update.
  void expectRuns(std::int64_t runs)
  {
    EXPECT_EQ(this->Made.update(this->Property, this->Input, this->Level), "");
    EXPECT_EQ(this->Made.record().Runs, runs);
  }

  vtkNew<vtkVolumeProperty> Property;
  Blending Blend;
  TableInput Input;
  AccuracyLevel Level = DefaultAccuracy;
  TransferTables Made;
};

TEST_F(Tables, AreMadeAgainForOtherFunctionsAndRanges)
{
  this->expectRuns(1);
  this->expectRuns(1);
  const Fingerprint shown = this->Made.shown();
  this->Property->GetScalarOpacity()->AddPoint(0.3, 0.7);
  this->expectRuns(2);
  EXPECT_NE(this->Made.shown(), shown);
  this->Property->GetRGBTransferFunction()->AddRGBPoint(0.3, 0.1, 0.2, 0.3);
  this->expectRuns(3);
  this->Property->GetScalarOpacity(1)->AddPoint(0.3, 0.7); // which isn't drawn
  this->expectRuns(3);
  this->Input.Range.High = 2;
  this->expectRuns(4);
  this->Input.Law = OpacityLaw::Structured;
  this->expectRuns(5);
  this->Blend.Mode = BlendMode::Additive;
  this->expectRuns(6);
}

TEST_F(Tables, OfAnotherAccuracyShowTheSame)
{
  this->expectRuns(1);
  const Fingerprint shown = this->Made.shown();
  this->Level = AccurateAccuracy;
  this->expectRuns(2);
  EXPECT_EQ(this->Made.shown(), shown);
}

TEST_F(Tables, WeightsAreNoPartOfThem)
{
  this->drawThree();
  this->expectRuns(1);
  const Fingerprint shown = this->Made.shown();
  this->Property->SetComponentWeight(1, 0.25);
  this->expectRuns(1);
  EXPECT_NE(this->Made.shown(), shown);
}

TEST_F(Tables, FollowTheComponentsThatAreDrawn)
{
  this->drawThree();
  this->expectRuns(1);
  EXPECT_EQ(this->Made.components().count(), 3);
  EXPECT_EQ(this->Made.components().Tables.size(), 2u);
  EXPECT_EQ(this->Made.bufferSizes().size(), 3u);
  this->Input.Mix = ComponentMix::Single;
  this->Input.ExtraRanges.clear();
  this->expectRuns(2);
  EXPECT_TRUE(this->Made.components().isSingle());
  EXPECT_TRUE(this->Made.components().Tables.empty());
  const std::vector<BufferSize> sizes = this->Made.bufferSizes();
  ASSERT_EQ(sizes.size(), 1u);
  EXPECT_EQ(sizes[0].Texels, this->Made.first().Values.size());
  EXPECT_EQ(sizes[0].BytesPerTexel, 36u);
}

// A step asks for as many entries as a table may have; of the least that any GL takes, too.
TEST_F(Tables, TogetherFitTheBuffer)
{
  this->Property->GetScalarOpacity()->AddPoint(0.3, 0.7);
  this->Property->GetScalarOpacity()->AddPoint(0.3 + 1e-9, 0.1);
  this->drawThree();
  this->expectRuns(1);
  const std::size_t fine = this->Made.first().Values.size();
  EXPECT_GT(fine, 65000u);
  this->Input.MostEntries = 65536;
  this->expectRuns(2);
  std::size_t entries = this->Made.first().Values.size();
  EXPECT_GT(entries, fine / 8);
  for (const IntegralTable& table : this->Made.components().Tables)
  {
    entries += table.Values.size();
  }
  EXPECT_LE(entries, 65536u);
}

TEST_F(Tables, AreVisibleIfAnyComponentIs)
{
  this->Property->GetScalarOpacity()->RemoveAllPoints();
  this->Property->GetScalarOpacity()->AddPoint(0.0, 0.0);
  this->expectRuns(1);
  EXPECT_FALSE(this->Made.isVisible());
  this->drawThree();
  this->expectRuns(2);
  EXPECT_TRUE(this->Made.isVisible());
}

TEST_F(Tables, SayWhichUnitDistanceIsWrong)
{
  this->drawThree();
  this->Property->SetScalarOpacityUnitDistance(2, 0.0);
  const std::string error = this->Made.update(this->Property, this->Input, this->Level);
  EXPECT_NE(error.find("component 2 is 0"), std::string::npos) << error;
}
} // namespace
