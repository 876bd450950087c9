// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// After VTK's TestGPURayCastCropping and TestGPURayCastCropping1.
#include "VtkScene.h"

#include "CpuReference.h"

#include "vtkCullerCollection.h"
#include "vtkFrustumCoverageCuller.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkTransform.h"

namespace
{
using namespace tetmarch::testing;

using CropPlanes = std::array<double, 6>;
constexpr CropPlanes Planes{ { 6.3, 12.7, 7.1, 13.4, 6.6, 12.2 } };

CropPlanes planesForImageMapper(vtkImageData* image)
{
  const Vec3 low = forImageMapper(image, { Planes[0], Planes[2], Planes[4] });
  const Vec3 high = forImageMapper(image, { Planes[1], Planes[3], Planes[5] });
  return { { low[0], high[0], low[1], high[1], low[2], high[2] } };
}

// Eight shells in light, four in a row, each turned and cropped otherwise.
class Cropped : public testing::Test
{
protected:
  static constexpr int Width = 320;
  static constexpr int Height = 160;

  Cropped()
  {
    setFunctions(this->Property, 50.0, 255.0, 0.8);
    this->Property->SetScalarOpacityUnitDistance(1.0);
    this->Property->ShadeOn();
    this->Property->SetSpecular(0.0); // before VTK 9.2 not as ours
    this->Renderer->SetBackground(0.1, 0.2, 0.4);
    this->Window->AddRenderer(this->Renderer);
    vtkFrustumCoverageCuller::SafeDownCast(this->Renderer->GetCullers()->GetLastItem())
      ->SetSortingStyleToBackToFront();
    const int flags[] = { VTK_CROP_SUBVOLUME, VTK_CROP_CROSS, VTK_CROP_INVERTED_CROSS, 24600,
      VTK_CROP_FENCE, VTK_CROP_INVERTED_FENCE, 1, 67117057 };
    for (int i = 0; i < 8; ++i)
    {
      vtkNew<vtkTransform> transform;
      transform->PostMultiply();
      transform->Translate(-10.0, -10.0, -10.0);
      transform->RotateX(i < 4 ? i * 90.0 + 20.0 : 20.0);
      transform->RotateY(i < 4 ? 20.0 : (i - 4) * 90.0 + 20.0);
      transform->Translate(24.0 * (i % 4), 24.0 * (i / 4), 0.0);
      this->Flags[i] = flags[i];
      this->Volumes[i]->SetUserTransform(transform);
      this->Volumes[i]->SetProperty(this->Property);
      this->Renderer->AddVolume(this->Volumes[i]);
    }
  }

  // Of mappers that are made one like the other.
  template <typename Make>
  Image draw(const Make& make, CropPlanes planes)
  {
    for (int i = 0; i < 8; ++i)
    {
      const auto mapper = make();
      mapper->CroppingOn();
      mapper->SetCroppingRegionPlanes(planes.data());
      mapper->SetCroppingRegionFlags(this->Flags[i]);
      this->Volumes[i]->SetMapper(mapper);
    }
    this->Renderer->ResetCamera();
    this->Renderer->GetActiveCamera()->Zoom(2.2);
    this->Window->Render();
    return framePictureOf(this->Window);
  }

  vtkSmartPointer<vtkRenderWindow> Window = makeWindow(Width, Height);
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkVolumeProperty> Property;
  vtkNew<vtkVolume> Volumes[8];
  int Flags[8];
};

TEST_F(Cropped, EightWays)
{
  const auto image = makeShell();
  const Grid grid = tetrahedraOf(image);
  const auto makeOurs = [&]
  {
    auto mapper = vtkSmartPointer<vtkTetMarchVolumeMapper>::New();
    mapper->SetInputData(grid);
    mapper->SetOpacityLawToStructured();
    mapper->CollectDiagnosticsOn();
    return mapper;
  };
  const Image ours = this->draw(makeOurs, Planes);
  for (vtkVolume* volume : this->Volumes)
  {
    expectReference(
      vtkTetMarchVolumeMapper::SafeDownCast(volume->GetMapper()), volume, Width, Height);
  }
  const Image rivals =
    this->draw([&] { return makeImageMapper(image, 0.05); }, planesForImageMapper(image));
  for (vtkVolume* volume : this->Volumes)
  {
    volume->VisibilityOff();
  }
  this->Window->Render();
  expectLike(ours, rivals, framePictureOf(this->Window), 6.0);
}

TEST(CroppedNear, AFence)
{
  const auto image = makeShell();
  Scene scene(tetrahedraOf(image), 100, 100);
  scene.Mapper->SetOpacityLawToStructured();
  setFunctions(scene.property(), 0.0, 255.0, 0.5);
  scene.property()->SetScalarOpacityUnitDistance(1.0);
  const auto rival = makeImageMapper(image, 0.02);
  scene.camera()->SetPosition(13.0, 15.0, 50.0);
  scene.camera()->SetFocalPoint(10.0, 10.0, 10.0);
  scene.Renderer->ResetCamera();
  scene.camera()->Zoom(2.0);
  expectLike(scene, rival, 3.0, "whole");
  scene.Mapper->CroppingOn();
  CropPlanes planes = Planes;
  scene.Mapper->SetCroppingRegionPlanes(planes.data());
  scene.Mapper->SetCroppingRegionFlagsToFence();
  rival->CroppingOn();
  planes = planesForImageMapper(image);
  rival->SetCroppingRegionPlanes(planes.data());
  rival->SetCroppingRegionFlagsToFence();
  expectParity(scene);
  expectLike(scene, rival, 3.0, "fence");
}
} // namespace
