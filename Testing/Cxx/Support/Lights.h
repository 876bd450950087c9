// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Lights that shine on the unit cube
 */
#ifndef tetmarch_testing_Lights_h
#define tetmarch_testing_Lights_h

#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

namespace tetmarch::testing
{
/// A light of the scene, from there to the middle of the unit cube.
inline vtkSmartPointer<vtkLight> addLight(vtkRenderer* renderer, double x, double y, double z)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToSceneLight();
  light->SetPosition(x, y, z);
  light->SetFocalPoint(0.5, 0.5, 0.5);
  renderer->AddLight(light);
  return light;
}

/// From there in all directions.
inline vtkSmartPointer<vtkLight> addPointLight(vtkRenderer* renderer, double x, double y, double z)
{
  auto light = addLight(renderer, x, y, z);
  light->PositionalOn();
  light->SetConeAngle(180.0);
  return light;
}

/// A green point light beside the cube that fades with the distance.
inline void addFadingLight(vtkRenderer* renderer)
{
  const auto light = addPointLight(renderer, -0.2, 1.4, 0.9);
  light->SetAttenuationValues(0.5, 0.3, 0.2);
  light->SetDiffuseColor(0.2, 0.9, 0.4);
}

inline void addSpotlight(vtkRenderer* renderer)
{
  const auto light = addLight(renderer, 1.5, 0.3, 2.0);
  light->PositionalOn();
  light->SetConeAngle(15.0);
  light->SetExponent(3.0);
}

/// A light with blue highlights that the camera carries beside it.
inline void addCameraLight(vtkRenderer* renderer)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(-1.0, 0.5, 1.0);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetSpecularColor(0.0, 0.0, 1.0);
  renderer->AddLight(light);
}

inline void addDimColouredHeadlight(vtkRenderer* renderer)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToHeadlight();
  light->SetColor(1.0, 0.6, 0.3);
  light->SetIntensity(0.8);
  light->SetAmbientColor(0.2, 0.1, 0.0);
  renderer->AddLight(light);
}

/// Beside others: a weak white headlight.
inline void addFillLight(vtkRenderer* renderer)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToHeadlight();
  light->SetIntensity(0.3);
  renderer->AddLight(light);
}

/// An orange light inside the cube, and a weak shadow from beside it.
inline void addLightsThatCastShadows(vtkRenderer* renderer)
{
  addPointLight(renderer, 0.4, 0.55, 0.6)->SetDiffuseColor(1.0, 0.5, 0.1);
  addLight(renderer, -2.0, 1.0, 0.0)->SetShadowAttenuation(0.4f);
}
} // namespace tetmarch::testing

#endif
