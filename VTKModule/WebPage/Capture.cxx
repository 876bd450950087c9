// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WebPage/Capture.h"

#include "GL/BlockAttributes.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkTetMarchSettings.h"
#include "vtkTetMarchSmartVolumeMapper.h"
#include "vtkTetMarchVolumeMapper.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

// Without peeling and stereo each volume is drawn once, and nothing comes to the screen.
class QuietWindow
{
public:
  explicit QuietWindow(vtkRenderer* renderer)
    : Renderer(renderer)
    , Window(renderer->GetRenderWindow())
    , Swaps(Window->GetSwapBuffers())
    , Stereo(Window->GetStereoRender())
    , Peels(renderer->GetUseDepthPeeling())
    , PeelsVolumes(renderer->GetUseDepthPeelingForVolumes())
  {
    this->Window->SetSwapBuffers(0);
    this->Window->SetStereoRender(0);
    renderer->SetUseDepthPeeling(0);
    renderer->SetUseDepthPeelingForVolumes(false);
  }
  ~QuietWindow()
  {
    this->Renderer->SetUseDepthPeeling(this->Peels);
    this->Renderer->SetUseDepthPeelingForVolumes(this->PeelsVolumes);
    this->Window->SetStereoRender(this->Stereo);
    this->Window->Render();
    this->Window->SetSwapBuffers(this->Swaps);
  }
  QuietWindow(const QuietWindow&) = delete;
  QuietWindow& operator=(const QuietWindow&) = delete;

private:
  vtkRenderer* Renderer;
  vtkRenderWindow* Window;
  int Swaps;
  int Stereo;
  int Peels;
  bool PeelsVolumes;
};

vtkTetMarchSettings* settingsOf(vtkAbstractVolumeMapper* mapper)
{
  if (auto* mesh = vtkTetMarchVolumeMapper::SafeDownCast(mapper))
  {
    return mesh->GetSettings();
  }
  auto* structured = vtkTetMarchSmartVolumeMapper::SafeDownCast(mapper);
  return structured ? structured->GetSettings() : nullptr;
}

void describeVolume(vtkVolume* volume, bool isCaptured, std::vector<std::string>& omissions)
{
  auto* mapper = vtkAbstractVolumeMapper::SafeDownCast(volume->GetMapper());
  vtkTetMarchSettings* settings = settingsOf(mapper);
  if (!isCaptured)
  {
    omissions.push_back(
      std::string("A volume is not in the page: ") +
      (!mapper      ? "it has no mapper."
        : !settings ? std::string("its mapper is a ") + mapper->GetClassName() +
                        "; the page shows those of vtkTetMarchVolumeMapper and "
                        "vtkTetMarchSmartVolumeMapper."
                    : "its mapper has nothing to draw, reported an error, or draws with other "
                      "processes."));
  }
  else if (settings->GetViewMode() != vtkTetMarchSettings::VIEW_PICTURE)
  {
    omissions.push_back("The view mode of a volume is not in the page: it shows the picture.");
  }
}

bool hasCameraLight(vtkRenderer* renderer)
{
  vtkCollectionSimpleIterator at;
  vtkLightCollection* lights = renderer->GetLights();
  lights->InitTraversal(at);
  bool found = false;
  while (vtkLight* light = lights->GetNextLight(at))
  {
    found = found || (light->GetSwitch() && light->LightTypeIsCameraLight());
  }
  return found;
}

// Of volumes: those of surfaces follow the camera in the page, too.
void describeLights(
  const Capture& capture, vtkRenderer* renderer, std::vector<std::string>& omissions)
{
  const bool inScene = hasCameraLight(renderer);
  const auto follows = [&](const CaptureScope::Captured& one)
  {
    const int preset =
      settingsOf(vtkAbstractVolumeMapper::SafeDownCast(one.Volume->GetMapper()))->GetLightPreset();
    return preset == vtkTetMarchSettings::LIGHT_STUDIO ||
           (preset == vtkTetMarchSettings::LIGHT_OF_SCENE && inScene &&
             one.Volume->GetProperty()->GetShade());
  };
  if (std::any_of(capture.Volumes.begin(), capture.Volumes.end(), follows))
  {
    omissions.push_back("Lights that follow the camera, other than headlights, stay in the page "
                        "where they are in this picture.");
  }
}

// Surfaces or volumes; windows have renderers for other things, such as ParaView's cross at the
// centre of rotation.
bool showsData(vtkRenderer* renderer)
{
  vtkCollectionSimpleIterator at;
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal(at);
  while (vtkProp* prop = renderer->GetDraw() ? props->GetNextProp(at) : nullptr)
  {
    if (prop->GetVisibility() && (prop->IsA("vtkActor") || prop->IsA("vtkVolume")) &&
        !prop->IsA("vtkPVCenterAxesActor"))
    {
      return true;
    }
  }
  return false;
}

bool hasOtherRenderers(vtkRenderer* renderer)
{
  vtkCollectionSimpleIterator at;
  vtkRendererCollection* all = renderer->GetRenderWindow()->GetRenderers();
  all->InitTraversal(at);
  while (vtkRenderer* other = all->GetNextRenderer(at))
  {
    if (other != renderer && showsData(other))
    {
      return true;
    }
  }
  return false;
}

void describeView(vtkRenderer* renderer, std::vector<std::string>& omissions)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const double* center = camera->GetWindowCenter();
  const double* shear = camera->GetViewShear();
  if (camera->GetUserTransform() || camera->GetUserViewTransform() ||
      camera->GetUseOffAxisProjection() || camera->GetUseHorizontalViewAngle() || center[0] != 0 ||
      center[1] != 0 || shear[0] != 0 || shear[1] != 0)
  {
    omissions.push_back(
      "The camera's own transform, window centre, shear and horizontal view angle "
      "are not in the page: it has a plain perspective or parallel camera.");
  }
  if (hasOtherRenderers(renderer))
  {
    omissions.push_back("The page shows one renderer; the others of the window are left out.");
  }
}

} // namespace

Capture captureScene(vtkRenderer* renderer)
{
  Capture capture;
  {
    const QuietWindow quiet(renderer);
    CaptureScope scope(renderer->GetRenderWindow());
    renderer->GetRenderWindow()->Render();
    capture.Volumes = std::move(scope.Volumes);
  }
  vtkCollectionSimpleIterator at;
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal(at);
  while (vtkProp* prop = props->GetNextProp(at))
  {
    auto* volume = vtkVolume::SafeDownCast(prop);
    if (volume && volume->GetVisibility())
    {
      const bool isCaptured = std::any_of(capture.Volumes.begin(), capture.Volumes.end(),
        [&](const CaptureScope::Captured& one)
        {
          // ParaView's volume is one that draws by another.
          return one.Volume == volume || one.Volume->GetMapper() == volume->GetMapper();
        });
      describeVolume(volume, isCaptured, capture.Omissions);
    }
  }
  describeLights(capture, renderer, capture.Omissions);
  describeView(renderer, capture.Omissions);
  capture.Surfaces = opaqueSurfaces(renderer, capture.Omissions, blockAttributes);
  return capture;
}

} // namespace tetmarch
