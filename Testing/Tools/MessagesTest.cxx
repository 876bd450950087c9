// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Messages.h"
#include "ProgressBar.h"

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

TEST(ProgressBar, Format)
{
  EXPECT_EQ(tetmarch::FormatProgress("reading", 0.5),
    "reading [" + std::string(15, '#') + std::string(15, ' ') + "] 50 %");
  EXPECT_EQ(tetmarch::FormatProgress("x", -1.0), "x [" + std::string(30, ' ') + "] 0 %");
  EXPECT_EQ(tetmarch::FormatProgress("x", 2.0), "x [" + std::string(30, '#') + "] 100 %");
  EXPECT_EQ(tetmarch::FormatProgress("x", std::nan("")), "x [" + std::string(30, ' ') + "] 0 %");
}
