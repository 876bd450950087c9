// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WebPage/SceneSurfaces.h"

#include "WebPage/ActorOmissions.h"
#include "WebPage/SurfaceTriangles.h"

#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

std::array<double, 3> colorOf(const double* c) { return { { c[0], c[1], c[2] } }; }

void setMaterial(const OpaqueSurface& drawn, Surface& surface)
{
  vtkProperty* property = drawn.Actor->GetProperty();
  surface.Color = drawn.BlockColor.value_or(colorOf(property->GetDiffuseColor()));
  surface.AmbientColor = drawn.BlockColor.value_or(colorOf(property->GetAmbientColor()));
  surface.SpecularColor = colorOf(property->GetSpecularColor());
  surface.Ambient = property->GetAmbient();
  surface.Diffuse = property->GetDiffuse();
  surface.Specular = property->GetSpecular();
  surface.SpecularPower = property->GetSpecularPower();
  surface.Lighting = property->GetLighting();
  surface.Flat = property->GetInterpolation() == VTK_FLAT;
  surface.FrontFaces = !property->GetFrontfaceCulling();
  surface.BackFaces = !property->GetBackfaceCulling();
}

bool isPlainHeadlight(vtkLight* light)
{
  const double* color = light->GetDiffuseColor();
  const double* specular = light->GetSpecularColor();
  const auto isOne = [](double x) { return x == 1.0; };
  return light->LightTypeIsHeadlight() && !light->GetPositional() && isOne(light->GetIntensity()) &&
         std::all_of(color, color + 3, isOne) && std::all_of(specular, specular + 3, isOne);
}

// Without a light VTK adds a headlight.
bool isLitByOneHeadlight(vtkRenderer* renderer)
{
  vtkLightCollection* lights = renderer->GetLights();
  int others = 0;
  int headlights = 0;
  vtkCollectionSimpleIterator at;
  lights->InitTraversal(at);
  while (vtkLight* light = lights->GetNextLight(at))
  {
    if (light->GetSwitch())
    {
      ++(isPlainHeadlight(light) ? headlights : others);
    }
  }
  const bool made = lights->GetNumberOfItems() == 0 && renderer->GetAutomaticLightCreation();
  return others == 0 && headlights == (made ? 0 : 1);
}

} // namespace

std::vector<Surface> opaqueSurfaces(
  vtkRenderer* renderer, std::vector<std::string>& omissions, BlockAttributes attributes)
{
  std::vector<Surface> surfaces;
  for (const OpaqueSurface& drawn : opaqueSurfaces(renderer, attributes))
  {
    if (drawsPolygons(drawn.Mapper))
    {
      Surface surface;
      setMaterial(drawn, surface);
      addTriangles(drawn, surface);
      surfaces.push_back(std::move(surface));
    }
  }
  surfaces.erase(std::remove_if(surfaces.begin(), surfaces.end(),
                   [](const Surface& surface) { return surface.Triangles.empty(); }),
    surfaces.end());
  addActorOmissions(renderer, omissions);
  if (!surfaces.empty() && !isLitByOneHeadlight(renderer))
  {
    omissions.push_back(
      "The lights of the scene do not light the surfaces in the page: it has a headlight.");
  }
  return surfaces;
}

} // namespace tetmarch
