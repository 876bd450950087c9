// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes of images, cut into tetrahedra: the mapper for meshes draws what the CPU reference does,
// and what VTK's mapper draws of the image.
#include "CpuReference.h"
#include "ImageSceneParams.h"
#include "VtkScene.h"

#include <cmath>

namespace
{
using namespace tetmarch::testing;

class AsTetrahedra : public testing::TestWithParam<ImageScene>
{
};

TEST_P(AsTetrahedra, OursIsTheReferenceAndLikeVtk)
{
  const auto data = this->GetParam().MakeData();
  const auto rival = makeFineSmartMapper(tenthOfAVoxel(data));
  rival->SetInputDataObject(data);
  Scene scene(tetrahedraOf(data), ImageSceneWindow::Width, ImageSceneWindow::Height);
  vtkTetMarchVolumeMapper* mapper = scene.Mapper;
  mapper->SetOpacityLawToStructured();
  scene.property()->SetScalarOpacityUnitDistance(1.0);
  ImageStage stage{ rival, scene.Volume, scene.property(), scene.Renderer };
  arrange(this->GetParam(), stage);
  mapper->SetBlendMode(rival->GetBlendMode());
  mapper->SetClippingPlanes(rival->GetClippingPlanes());
  mapper->SetCropping(rival->GetCropping());
  mapper->SetCroppingRegionPlanes(rival->GetCroppingRegionPlanes());
  mapper->SetCroppingRegionFlags(rival->GetCroppingRegionFlags());
  expectParityWithOpaque(scene);
  if (std::isfinite(this->GetParam().Tetrahedra))
  {
    expectLike(scene, rival, this->GetParam().Tetrahedra);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, AsTetrahedra,
  testing::ValuesIn(scenesThat([](const ImageScene& scene) { return scene.Tetrahedra > 0.0; })),
  nameOf);
} // namespace
