// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Scenes of images as parameters of tests
 */
#ifndef tetmarch_testing_ImageSceneParams_h
#define tetmarch_testing_ImageSceneParams_h

#include "ImageScene.h"

#include <algorithm>
#include <cctype>
#include <gtest/gtest.h>
#include <iterator>

namespace tetmarch::testing
{
/// For messages of GoogleTest.
inline void PrintTo(const ImageScene& scene, std::ostream* to) { *to << scene.Name; }

template <typename IsWanted>
std::vector<ImageScene> scenesThat(const IsWanted& isWanted)
{
  std::vector<ImageScene> wanted;
  for (const ImageScene& scene : imageScenes())
  {
    if (isWanted(scene))
    {
      wanted.push_back(scene);
    }
  }
  return wanted;
}

inline std::string nameOf(const ::testing::TestParamInfo<ImageScene>& info)
{
  std::string name;
  std::copy_if(info.param.Name.begin(), info.param.Name.end(), std::back_inserter(name),
    [](unsigned char c) { return std::isalnum(c) != 0; });
  return name;
}
} // namespace tetmarch::testing

#endif
