// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The scene of a test as a web page
 */
#ifndef tetmarch_testing_ScenePage_h
#define tetmarch_testing_ScenePage_h

#include "Scene.h"

#include "WebPages.h"

#include <gtest/gtest.h>
#include <string>

namespace tetmarch::testing
{
/// The running test, with a number if it isn't asked for the first time.
inline std::string nameOfPage()
{
  static std::string last;
  static int number = 0;
  const ::testing::TestInfo* test = ::testing::UnitTest::GetInstance()->current_test_info();
  const std::string name = std::string(test->test_suite_name()) + "." + test->name();
  number = name == last ? number + 1 : 1;
  last = name;
  return number == 1 ? name : name + "." + std::to_string(number);
}

/// keepWebPage() of what stands in the window of a scene.
inline void keepScenePage(vtkRenderWindow* window)
{
  keepWebPage(window, framePictureOf(window), nameOfPage());
}
} // namespace tetmarch::testing

#endif
