// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WebPage/SceneSurfaces.h"

#include "WebPage/ActorOmissions.h"
#include "WebPage/SurfaceTriangles.h"

#include "vtkActor.h"
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
  if (!surfaces.empty())
  {
    const std::vector<SurfaceLight> lights = surfaceLights(renderer, omissions);
    for (Surface& surface : surfaces)
    {
      surface.Lights = lights;
    }
  }
  addActorOmissions(renderer, omissions);
  return surfaces;
}

} // namespace tetmarch
