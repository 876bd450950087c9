// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WebPage/SurfaceLights.h"

#include "Geometry/Vector3.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"

namespace tetmarch
{
namespace
{

constexpr std::size_t MostLights = 8; // Shaders/web/surface.frag.glsl

Vector3 vectorOf(const double* p) { return { { p[0], p[1], p[2] } }; }

// A headlight shines along the view, as VTK draws it, wherever it has been moved.
SurfaceLight lightOf(vtkLight* light)
{
  SurfaceLight found;
  found.FollowsCamera = !light->LightTypeIsSceneLight();
  if (light->LightTypeIsCameraLight())
  {
    found.Direction = vectorOf(light->GetFocalPoint()) - vectorOf(light->GetPosition());
  }
  else if (light->LightTypeIsSceneLight())
  {
    double ends[2][3];
    light->GetTransformedFocalPoint(ends[0]);
    light->GetTransformedPosition(ends[1]);
    found.Direction = vectorOf(ends[0]) - vectorOf(ends[1]);
  }
  found.Color = scaled(light->GetIntensity(), vectorOf(light->GetDiffuseColor()));
  return found;
}

} // namespace

std::vector<SurfaceLight> surfaceLights(vtkRenderer* renderer, std::vector<std::string>& omissions)
{
  std::vector<SurfaceLight> found;
  int others = 0;
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator at;
  lights->InitTraversal(at);
  while (vtkLight* light = lights->GetNextLight(at))
  {
    const bool shown = !light->GetPositional() && found.size() < MostLights;
    if (light->GetSwitch() && shown)
    {
      found.push_back(lightOf(light));
    }
    others += light->GetSwitch() && !shown ? 1 : 0;
  }
  if (others > 0)
  {
    omissions.push_back("Lights (" + std::to_string(others) +
                        ") do not light the surfaces in the "
                        "page: it has up to " +
                        std::to_string(MostLights) + " lights that are not positional.");
  }
  if (lights->GetNumberOfItems() == 0 && renderer->GetAutomaticLightCreation())
  {
    found.emplace_back();
  }
  return found;
}

} // namespace tetmarch
