// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// After VTK's tests of vtkSmartVolumeMapper and vtkGPUVolumeRayCastMapper: the ground truth of
// images is what VTK's mapper draws, within that mapper's own error, and ours is the ground truth.
#include "ImageSceneParams.h"
#include "ImageSceneTruth.h"

#include "vtkTetMarchSmartVolumeMapper.h"

#include <iostream>

namespace
{
using namespace tetmarch::testing;

void expectSomething(const Image& picture)
{
  EXPECT_GT(compare(picture, Image(picture.Width, picture.Height), {}, 0.0, Channels::Rgb).Max, 0.1)
    << "nothing to be seen";
}

class ByVtk : public testing::TestWithParam<ImageScene>
{
};

TEST_P(ByVtk, IsTheTruthWithinItsError)
{
  const ImageScene& scene = this->GetParam();
  const auto mapper = makeFineSmartMapper(tenthOfAVoxel(scene.MakeData()));
  ImageSceneWindow window(scene, mapper);
  const Image picture = window.drawInFloat();
  ASSERT_EQ(mapper->GetLastUsedRenderMode(), vtkSmartVolumeMapper::GPURenderMode);
  expectSomething(picture);
  if (scene.HasTruth)
  {
    const ImageSceneTruth truth(window.stage(), window.data(), picture.Width, picture.Height);
    const Difference difference = differenceFrom(truth, picture);
    std::cout << "[ MEASURED ] " << difference.text() << '\n';
    EXPECT_GT(difference.Pixels, 30u);
    EXPECT_LE(255.0 * difference.Rms, scene.Rival.Most)
      << difference.text() << ", not but by this: " << scene.Rival.Because;
  }
}

class ByOurs : public testing::TestWithParam<ImageScene>
{
};

TEST_P(ByOurs, IsTheTruth)
{
  const ImageScene& scene = this->GetParam();
  const auto mapper = vtkSmartPointer<vtkTetMarchSmartVolumeMapper>::New();
  ImageSceneWindow window(scene, mapper);
  const Image picture = window.drawInFloat();
  expectSomething(picture);
  if (scene.HasTruth)
  {
    const ImageSceneTruth truth(window.stage(), window.data(), picture.Width, picture.Height);
    const Difference difference = differenceFrom(truth, picture);
    std::cout << "[ MEASURED ] " << difference.text() << '\n';
    EXPECT_LE(255.0 * difference.Rms, 0.3) << difference.text();
    EXPECT_LE(255.0 * difference.Max, 2.0) << difference.text();
  }
}

class InLight : public testing::TestWithParam<ImageScene>
{
};

// There is no truth to compare with.
TEST_P(InLight, OursIsLikeVtk)
{
  const ImageScene& scene = this->GetParam();
  const auto draw = [&](vtkSmartVolumeMapper* mapper)
  { return ImageSceneWindow(scene, mapper).drawInFloat(); };
  const Image ours = draw(vtkSmartPointer<vtkTetMarchSmartVolumeMapper>::New());
  const Image rivals = draw(makeFineSmartMapper(tenthOfAVoxel(scene.MakeData())));
  const Difference difference = compare(ours, rivals, silhouette(ours, rivals), 0.0, Channels::Rgb);
  std::cout << "[ MEASURED ] " << difference.text() << '\n';
  EXPECT_LE(255.0 * difference.Rms, scene.Rival.Most)
    << difference.text() << ", not but by this: " << scene.Rival.Because;
}

INSTANTIATE_TEST_SUITE_P(Scenes, ByVtk,
  testing::ValuesIn(
    scenesThat([](const ImageScene& scene) { return scene.Rival.Most != NoPicture; })),
  nameOf);
INSTANTIATE_TEST_SUITE_P(Scenes, ByOurs,
  testing::ValuesIn(
    scenesThat([](const ImageScene& scene) { return std::string(scene.NotMarched).empty(); })),
  nameOf);
INSTANTIATE_TEST_SUITE_P(Scenes, InLight,
  testing::ValuesIn(scenesThat([](const ImageScene& scene) { return !scene.HasTruth; })), nameOf);
} // namespace
