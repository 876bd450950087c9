// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Messages.h"
#include "ProgressBar.h"

#include "vtkNew.h"

#include <gtest/gtest.h>

#include <cmath>

TEST(Messages, SourceLinesAndAddressesAreCutOff)
{
  EXPECT_EQ(
    tetmarch::CleanVTKMessage("ERROR: In /a/b/vtkFoo.cxx, line 123\nvtkFoo (0x55d0c8a0b2c0): "
                              "Something (12) is wrong.\n\n"),
    "vtkFoo: Something (12) is wrong.");
  EXPECT_EQ(
    tetmarch::CleanVTKMessage("Generic Warning: In /a/vtkFoo.cxx, line 1\nOne line\nand another\n"),
    "One line\nand another");
  EXPECT_EQ(tetmarch::CleanVTKMessage("plain"), "plain");
}

// As readers of VTK do with some damaged files.
TEST(Messages, WhatIsSaidAMillionTimesIsPrintedTenTimes)
{
  const vtkNew<tetmarch::Messages> messages;
  const int before = tetmarch::Messages::GetNumberOfErrors();
  ::testing::internal::CaptureStderr();
  for (int i = 0; i < 1000; ++i)
  {
    messages->DisplayErrorText("ERROR: In /a/vtkFoo.cxx, line 1\nvtkFoo (0x55d0c8a0b2c0): wrong\n");
  }
  for (int i = 0; i < 1000; ++i)
  {
    messages->DisplayGenericWarningText("Generic Warning: In a, line 1\nError reading data\n");
  }
  messages->DisplayWarningText("once");
  messages->DisplayErrorText("ERROR: In /a/vtkFoo.cxx, line 1\nvtkFoo (0x55d0c8a0b2c0): wrong\n");
  std::string expected;
  for (const std::string text : { "vtkFoo: wrong", "Error reading data" })
  {
    for (int i = 0; i < 10; ++i)
    {
      expected += "tetmarch-render: error: " + text + "\n";
    }
    expected += "tetmarch-render: note: VTK says the same more often\n";
  }
  expected += "tetmarch-render: warning: once\ntetmarch-render: error: vtkFoo: wrong\n";
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), expected);
  EXPECT_EQ(tetmarch::Messages::GetNumberOfErrors(), before + 2001); // all are counted
}

TEST(ProgressBar, Format)
{
  EXPECT_EQ(tetmarch::FormatProgress("reading", 0.5),
    "reading [" + std::string(15, '#') + std::string(15, ' ') + "] 50 %");
  EXPECT_EQ(tetmarch::FormatProgress("x", -1.0), "x [" + std::string(30, ' ') + "] 0 %");
  EXPECT_EQ(tetmarch::FormatProgress("x", 2.0), "x [" + std::string(30, '#') + "] 100 %");
  EXPECT_EQ(tetmarch::FormatProgress("x", std::nan("")), "x [" + std::string(30, ' ') + "] 0 %");
}
