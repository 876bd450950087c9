// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Light/Lighting.h"

#include "vtkCollection.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkRenderer.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{
namespace
{

using Triple = std::array<double, 3>;

Triple triple(const double* v, double factor = 1)
{
  return { { v[0] * factor, v[1] * factor, v[2] * factor } };
}

bool isFinite(const Triple& v)
{
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

bool isBlack(const Triple& color) { return color == Triple{}; }

// Unit vector from one point to another; false if there is none.
bool makeDirection(const Triple& from, const Triple& to, Triple& direction)
{
  // hypot() neither overflows nor underflows, as squares do.
  const Triple way{ { to[0] - from[0], to[1] - from[1], to[2] - from[2] } };
  const double length = std::hypot(way[0], way[1], way[2]);
  if (!std::isfinite(length) || !(length > 0))
  {
    return false;
  }
  direction = { { way[0] / length, way[1] / length, way[2] / length } };
  return true;
}

// Set the light's position and direction. False if it has none.
bool place(vtkLight* light, LightSource& source)
{
  source.Positional = light->GetPositional() != 0;
  source.Headlight = !source.Positional && light->LightTypeIsHeadlight();
  const Triple position = triple(light->GetTransformedPosition());
  bool usable =
    makeDirection(position, triple(light->GetTransformedFocalPoint()), source.Direction);
  if (source.Positional)
  {
    source.Position = position;
    source.Attenuation = triple(light->GetAttenuationValues());
    // A cone angle of 90 degrees still makes a spot light, as in VTK's own shaders.
    const double angle = light->GetConeAngle();
    if (std::isfinite(angle) && angle <= 90)
    {
      source.ConeCosine = std::cos(vtkMath::RadiansFromDegrees(angle));
      source.Exponent = light->GetExponent();
    }
    else
    {
      usable = true; // it shines in all directions
    }
  }
  return usable && isFinite(source.Position) && isFinite(source.Attenuation) &&
         std::isfinite(source.Exponent);
}

// Set the light's colours. False if it is dark.
bool color(vtkLight* light, LightSource& source)
{
  const double intensity = light->GetSwitch() ? light->GetIntensity() : 0;
  source.Ambient = triple(light->GetAmbientColor(), intensity);
  source.Diffuse = triple(light->GetDiffuseColor(), intensity);
  source.Specular = triple(light->GetSpecularColor(), intensity);
  const double shadow = light->GetShadowAttenuation();
  source.ShadowStrength = std::min(std::max(0.0, shadow), 1.0); // NaN: 0
  return isFinite(source.Ambient) && isFinite(source.Diffuse) && isFinite(source.Specular) &&
         !(isBlack(source.Ambient) && isBlack(source.Diffuse) && isBlack(source.Specular));
}

} // namespace

Lighting lightingOf(vtkRenderer* renderer, vtkVolumeProperty* property)
{
  Lighting lighting;
  if (!property->GetShade())
  {
    return lighting;
  }
  lighting.TwoSided = renderer->GetTwoSidedLighting() != 0;
  lighting.Ambient = property->GetAmbient();
  lighting.Diffuse = property->GetDiffuse();
  lighting.Specular = property->GetSpecular();
  lighting.SpecularPower = property->GetSpecularPower();

  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  lights->InitTraversal(iterator);
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    LightSource source;
    if (place(light, source) && color(light, source))
    {
      if (lighting.Lights.size() < MostLights)
      {
        lighting.Lights.push_back(source);
      }
      else
      {
        ++lighting.LeftOut;
      }
    }
  }
  return lighting;
}

} // namespace tetmarch
