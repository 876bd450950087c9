// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Lights of all kinds, and a volume that they shine on
 */
#ifndef tetmarch_testing_LitVolume_h
#define tetmarch_testing_LitVolume_h

#include "Light/LightUniforms.h"
#include "Mesh/TetMesh.h"

#include "vtkNew.h"
#include "vtkTransform.h"
#include "vtkVolume.h"

#include <gtest/gtest.h>

namespace tetmarch::testing
{
using Triple = std::array<double, 3>;

inline LightSource pointLight(const Triple& position)
{
  LightSource light;
  light.Positional = true;
  light.Position = position;
  light.Attenuation = { { 0.5, 0.25, 0.125 } };
  light.ConeCosine = 0.75;
  light.Exponent = 3.0;
  light.ShadowStrength = 1.0;
  return light;
}

inline LightSource sunlight(const Triple& direction)
{
  LightSource light;
  light.Direction = direction;
  light.ShadowStrength = 1.0;
  return light;
}

inline LightSource headlight()
{
  LightSource light;
  light.Headlight = true;
  light.ShadowStrength = 1.0;
  return light;
}

/// A volume somewhere, whose mesh has its centre and its radius somewhere else again.
class LitVolume : public ::testing::Test
{
protected:
  LitVolume()
  {
    this->Mesh.Frame.Center = { { 0.25, -3.0, 7.0 } };
    this->Mesh.Frame.Radius = 2.5;
    this->Volume->SetUserTransform(this->Transform);
    this->Options.Shadows = ShadowMethod::AtVertices;
    this->Answers.Ambient = 0.25;
    this->Answers.Diffuse = 0.5;
    this->Answers.Specular = 0.75;
    this->Answers.SpecularPower = 20.0;
  }

  LightUniforms lights()
  {
    return makeLightUniforms(this->Answers, this->Options, this->Volume, this->Mesh.Frame);
  }

  Lighting Answers; // the property's numbers, and the lights
  EffectOptions Options;
  TetMesh Mesh;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkTransform> Transform;
};

inline void expectNear(const Triple& found, const Triple& expected, double tolerance)
{
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_NEAR(found[k], expected[k], tolerance) << k;
  }
}
} // namespace tetmarch::testing

#endif
