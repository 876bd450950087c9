// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LightOptions.h"

#include "Failure.h"
#include "Numbers.h"
#include "OptionValues.h"

#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkVolumeProperty.h"

namespace
{
void AddLight(const tetmarch::LightOption& option, vtkRenderer* renderer)
{
  vtkNew<vtkLight> light;
  light->SetIntensity(option.Intensity);
  if (option.From)
  {
    light->SetLightTypeToSceneLight();
    light->SetPosition(option.From->data());
    light->SetFocalPoint(0.0, 0.0, 0.0);
  }
  else
  {
    light->SetLightTypeToHeadlight();
  }
  renderer->AddLight(light);
}
} // namespace

namespace tetmarch
{

LightOption ParseLight(const std::string& value)
{
  const std::string headlight = "headlight";
  LightOption light;
  if (value.compare(0, headlight.size(), headlight) == 0)
  {
    const std::string rest = value.substr(headlight.size());
    const auto intensity = rest.empty() ? 1.0 : ParseNumber(rest.substr(1));
    if (!intensity || (!rest.empty() && rest[0] != ','))
    {
      throw UsageError("expected headlight or headlight,INTENSITY");
    }
    light.Intensity = *intensity;
  }
  else
  {
    const auto numbers = ParseList(value, { 3, 4 });
    light.From = { { numbers[0], numbers[1], numbers[2] } };
    light.Intensity = numbers.size() == 4 ? numbers[3] : 1.0;
    if (*light.From == std::array<double, 3>{})
    {
      throw UsageError("a light that shines from 0,0,0 has no direction");
    }
  }
  if (light.Intensity < 0.0)
  {
    throw UsageError("the intensity must be 0 or more");
  }
  return light;
}

void SetUpLight(const LightOptions& options, vtkRenderer* renderer, vtkVolumeProperty* property)
{
  property->SetShade(options.Shade);
  property->SetAmbient(options.Ambient.value_or(property->GetAmbient()));
  property->SetDiffuse(options.Diffuse.value_or(property->GetDiffuse()));
  property->SetSpecular(options.Specular.value_or(property->GetSpecular()));
  property->SetSpecularPower(options.SpecularPower.value_or(property->GetSpecularPower()));
  for (const LightOption& light : options.Lights)
  {
    AddLight(light, renderer);
  }
}

} // namespace tetmarch
