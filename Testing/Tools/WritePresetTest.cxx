// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Failure.h"
#include "TransferFunctionPreset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace
{
class WritePreset : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Folder = std::filesystem::path(testing::TempDir()) / "tetmarch-write-preset";
    std::filesystem::remove_all(this->Folder);
    std::filesystem::create_directory(this->Folder);
    this->Path = (this->Folder / "preset.json").string();
    this->Color->AddRGBPoint(-0.1, 0.1, 0.2, 0.3, 0.25, 0.75);
    this->Color->AddRGBPoint(1.0 / 3.0, 0.7, 0.8, 0.9, 0.5, 0.0);
    this->Color->AddRGBPoint(1e7, 1.0, 0.0, 0.5, 0.125, 1.0);
    this->Opacity->AddPoint(-0.1, 0.0, 0.375, 0.625);
    this->Opacity->AddPoint(1e7, 1.0 / 7.0, 0.5, 0.0);
  }
  void TearDown() override { std::filesystem::remove_all(this->Folder); }

  void ExpectSamePoints(const tetmarch::TransferFunctions& read)
  {
    ASSERT_EQ(read.Color->GetSize(), this->Color->GetSize());
    for (int i = 0; i < this->Color->GetSize(); ++i)
    {
      double expected[6];
      double node[6];
      this->Color->GetNodeValue(i, expected);
      read.Color->GetNodeValue(i, node);
      EXPECT_TRUE(std::equal(node, node + 6, expected)) << "colour point " << i;
    }
    ASSERT_EQ(read.Opacity->GetSize(), this->Opacity->GetSize());
    for (int i = 0; i < this->Opacity->GetSize(); ++i)
    {
      double expected[4];
      double node[4];
      this->Opacity->GetNodeValue(i, expected);
      read.Opacity->GetNodeValue(i, node);
      EXPECT_TRUE(std::equal(node, node + 4, expected)) << "opacity point " << i;
    }
  }

  std::filesystem::path Folder;
  std::string Path;
  vtkNew<vtkColorTransferFunction> Color;
  vtkNew<vtkPiecewiseFunction> Opacity;
};
} // namespace

TEST_F(WritePreset, ReadBackIsTheSameToTheLastBit)
{
  for (const int space : { VTK_CTF_RGB, VTK_CTF_HSV, VTK_CTF_LAB, VTK_CTF_DIVERGING,
         VTK_CTF_LAB_CIEDE2000, VTK_CTF_STEP })
  {
    this->Color->SetColorSpace(space);
    this->Color->SetHSVWrap(space != VTK_CTF_HSV);
    this->Color->SetNanColor(0.1, 0.9, 1.0 / 3.0);
    tetmarch::WritePreset(this->Path, "mine", this->Color, this->Opacity);
    const auto read = tetmarch::ReadPreset(this->Path);
    ExpectSamePoints(read);
    EXPECT_TRUE(read.HasOpacityOfItsOwn);
    EXPECT_EQ(read.Color->GetColorSpace(), space);
    EXPECT_EQ(read.Color->GetHSVWrap(), space != VTK_CTF_HSV);
    EXPECT_EQ(read.Color->GetScale(), VTK_CTF_LINEAR);
    EXPECT_EQ(read.Color->GetNanColor()[2], 1.0 / 3.0);
    // Nor does it change if it is stretched to the range that it has.
    ExpectSamePoints(tetmarch::ReadPreset(this->Path, std::array<double, 2>{ { -0.1, 1e7 } }));
  }
}

TEST_F(WritePreset, LogarithmicScale)
{
  this->Color->RemovePoint(-0.1);
  this->Color->SetScaleToLog10();
  tetmarch::WritePreset(this->Path, "mine", this->Color, this->Opacity);
  EXPECT_EQ(tetmarch::ReadPreset(this->Path).Color->GetScale(), VTK_CTF_LOG10);
}

TEST_F(WritePreset, TwoPointsAtOnePlaceStayTwo)
{
  this->Color->SetAllowDuplicateScalars(true);
  this->Opacity->SetAllowDuplicateScalars(true);
  this->Color->AddRGBPoint(1.0 / 3.0, 0.0, 1.0, 0.0);
  this->Opacity->AddPoint(5.0, 0.0);
  this->Opacity->AddPoint(5.0, 1.0);
  tetmarch::WritePreset(this->Path, "steps", this->Color, this->Opacity);
  ExpectSamePoints(tetmarch::ReadPreset(this->Path));
}

TEST_F(WritePreset, WhatCannotBeWrittenLeavesTheOlderFile)
{
  tetmarch::WritePreset(this->Path, "mine", this->Color, this->Opacity);
  vtkNew<vtkPiecewiseFunction> empty;
  try
  {
    tetmarch::WritePreset(this->Path, "mine", this->Color, empty);
    FAIL() << "an empty function was written";
  }
  catch (const tetmarch::Failure& failure)
  {
    EXPECT_STREQ(failure.what(),
      "a preset needs colours and opacities, but the function of opacity has no points");
  }
  ExpectSamePoints(tetmarch::ReadPreset(this->Path));
  EXPECT_THROW(tetmarch::WritePreset((this->Folder / "none" / "preset.json").string(), "mine",
                 this->Color, this->Opacity),
    tetmarch::Failure);
}

TEST_F(WritePreset, NameOfAnyBytes)
{
  tetmarch::WritePreset(this->Path, "\"quoted\" \xff", this->Color, this->Opacity);
  ExpectSamePoints(tetmarch::ReadPreset(this->Path));
}

TEST_F(WritePreset, ShapeOfColorPointsIsChecked)
{
  for (const char* const shape : { "[0.5]", "[0.5, 2]", "3", "[0.5, \"a\"]" })
  {
    try
    {
      tetmarch::ParsePreset(
        std::string(R"({"RGBPoints": [0, 1, 1, 1], "RGBPointsShape": )") + shape + "}", "p");
      FAIL() << shape << " was accepted";
    }
    catch (const tetmarch::Failure& failure)
    {
      EXPECT_STREQ(failure.what(),
        "preset 'p': RGBPointsShape must be an array of numbers from 0 to 1, 2 for each point of "
        "RGBPoints");
    }
  }
}
