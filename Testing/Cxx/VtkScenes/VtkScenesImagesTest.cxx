// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// After VTK's tests of vtkSmartVolumeMapper and vtkGPUVolumeRayCastMapper: the ground truth of
// images is what VTK's mapper draws, within that mapper's own error.
#include "ImageSceneTruth.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <iostream>

namespace tetmarch::testing
{
// For messages of GoogleTest.
void PrintTo(const ImageScene& scene, std::ostream* to) { *to << scene.Name; }
} // namespace tetmarch::testing

namespace
{
using namespace tetmarch::testing;

class ImageScenes : public testing::TestWithParam<ImageScene>
{
};

TEST_P(ImageScenes, AsVtkDrawsThem)
{
  const ImageScene& scene = this->GetParam();
  const auto mapper = makeFineSmartMapper(tenthOfAVoxel(scene.MakeData()));
  ImageSceneWindow window(scene, mapper);
  const Image picture = window.drawInFloat();
  ASSERT_EQ(mapper->GetLastUsedRenderMode(), vtkSmartVolumeMapper::GPURenderMode);
  EXPECT_GT(compare(picture, Image(picture.Width, picture.Height), {}, 0.0, Channels::Rgb).Max, 0.1)
    << "nothing to be seen";
  if (!scene.HasTruth)
  {
    return;
  }
  const ImageSceneTruth truth(window.stage(), window.data(), picture.Width, picture.Height);
  const Difference difference = differenceFrom(truth, picture);
  std::cout << "[ MEASURED ] " << difference.text() << '\n';
  EXPECT_GT(difference.Pixels, 30u);
  EXPECT_LE(255.0 * difference.Rms, scene.Rival.Most)
    << difference.text() << ", not but by this: " << scene.Rival.Because;
}

std::vector<ImageScene> drawnByVtk()
{
  std::vector<ImageScene> scenes = imageScenes();
  scenes.erase(std::remove_if(scenes.begin(), scenes.end(),
                 [](const ImageScene& scene) { return scene.Rival.Most == NoPicture; }),
    scenes.end());
  return scenes;
}

std::string nameOf(const testing::TestParamInfo<ImageScene>& info)
{
  std::string name;
  std::copy_if(info.param.Name.begin(), info.param.Name.end(), std::back_inserter(name),
    [](unsigned char c) { return std::isalnum(c) != 0; });
  return name;
}

INSTANTIATE_TEST_SUITE_P(OfVtk, ImageScenes, testing::ValuesIn(drawnByVtk()), nameOf);
} // namespace
