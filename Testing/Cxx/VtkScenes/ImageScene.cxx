// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageScene.h"

#include "VtkScene.h"

#include "../../Benchmark/FloatPicture.h"

#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkRectilinearGrid.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <cmath>

namespace tetmarch::testing
{
namespace
{
class FineSmartMapper : public vtkSmartVolumeMapper
{
public:
  static FineSmartMapper* New();
  vtkTypeMacro(FineSmartMapper, vtkSmartVolumeMapper);

  void setStep(double step)
  {
    this->SetRequestedRenderModeToGPU();
    this->InteractiveAdjustSampleDistancesOff();
    this->AutoAdjustSampleDistancesOff();
    this->SetSampleDistance(static_cast<float>(step));
    this->GPUMapper->LockSampleDistanceToInputSpacingOff();
  }

  void Render(vtkRenderer* renderer, vtkVolume* volume) override
  {
    // VTK 9.1 doesn't pass it on.
    this->GPUMapper->SetAverageIPScalarRange(this->GetAverageIPScalarRange());
    std::array<double, 6> planes;
    this->GetCroppingRegionPlanes(planes.data());
    vtkSmartPointer<vtkPlaneCollection> clipping = this->GetClippingPlanes();
    this->movePlanes(planes);
    this->Superclass::Render(renderer, volume);
    this->SetCroppingRegionPlanes(planes.data());
    this->SetClippingPlanes(clipping);
  }

private:
  // To where its GPU mapper must be told that they are (forImageMapper()).
  void movePlanes(const std::array<double, 6>& cropping)
  {
    auto* image = vtkImageData::SafeDownCast(this->GetInput());
    if (this->GetCropping())
    {
      const Vec3 low = forImageMapper(image, { cropping[0], cropping[2], cropping[4] });
      const Vec3 high = forImageMapper(image, { cropping[1], cropping[3], cropping[5] });
      this->SetCroppingRegionPlanes(low[0], high[0], low[1], high[1], low[2], high[2]);
    }
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0)
    vtkNew<vtkPlaneCollection> moved;
    for (int i = 0; this->ClippingPlanes && i < this->ClippingPlanes->GetNumberOfItems(); ++i)
    {
      vtkPlane* plane = this->ClippingPlanes->GetItem(i);
      const double* origin = plane->GetOrigin();
      vtkNew<vtkPlane> copy;
      copy->SetNormal(plane->GetNormal());
      copy->SetOrigin(forImageMapper(image, { origin[0], origin[1], origin[2] }).data());
      moved->AddItem(copy);
    }
    if (moved->GetNumberOfItems() > 0)
    {
      this->SetClippingPlanes(moved);
    }
#endif
  }
};
vtkStandardNewMacro(FineSmartMapper);
} // namespace

vtkSmartPointer<vtkSmartVolumeMapper> makeFineSmartMapper(double step)
{
  const auto mapper = vtkSmartPointer<FineSmartMapper>::New();
  mapper->setStep(step);
  return mapper;
}

double tenthOfAVoxel(vtkDataSet* data)
{
  double least = VTK_DOUBLE_MAX;
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    for (int a = 0; a < 3; ++a)
    {
      least = std::min(least, std::abs(image->GetSpacing()[a]));
    }
  }
  else if (auto* grid = vtkRectilinearGrid::SafeDownCast(data))
  {
    for (vtkDataArray* axis :
      { grid->GetXCoordinates(), grid->GetYCoordinates(), grid->GetZCoordinates() })
    {
      for (vtkIdType i = 1; i < axis->GetNumberOfTuples(); ++i)
      {
        least = std::min(least, axis->GetComponent(i, 0) - axis->GetComponent(i - 1, 0));
      }
    }
  }
  return 0.1 * least;
}

std::vector<ImageScene> imageScenes()
{
  std::vector<ImageScene> scenes = imageDataScenes();
  for (const auto& more : { imageModeScenes(), imageCameraScenes(), imageArrayScenes() })
  {
    scenes.insert(scenes.end(), more.begin(), more.end());
  }
  return scenes;
}

void arrange(const ImageScene& scene, ImageStage& stage)
{
  scene.Arrange(stage);
  stage.Renderer->SetActiveCamera(nullptr);
  if (scene.Look)
  {
    scene.Look(stage);
    return;
  }
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->Azimuth(25.0);
  camera->Elevation(35.0);
  stage.Renderer->ResetCamera();
  camera->Zoom(1.3);
}

void addPlane(ImageStage& stage, const Vec3& origin, const Vec3& normal)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(origin.data());
  plane->SetNormal(normal.data());
  stage.Mapper->AddClippingPlane(plane);
}

ImageSceneWindow::ImageSceneWindow(const ImageScene& scene, vtkSmartVolumeMapper* mapper)
  : Data(scene.MakeData())
  , Window(makeWindow(Width, Height))
  , Stage{ mapper, this->Volume, this->Volume->GetProperty(), this->Renderer }
{
  mapper->SetInputDataObject(this->Data);
  this->Volume->SetMapper(mapper);
  this->Renderer->AddVolume(this->Volume);
  this->Window->AddRenderer(this->Renderer);
  arrange(scene, this->Stage);
}

Image ImageSceneWindow::drawInFloat()
{
  // In the first frame of a window vtkFramebufferPass has no volumes.
  this->Window->Render();
  return bench::drawInFloat(this->Window, this->Renderer).OnBlack;
}
} // namespace tetmarch::testing
