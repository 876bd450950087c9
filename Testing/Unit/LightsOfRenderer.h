// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A renderer without a window, and which lights count of those that are added to it
 */
#ifndef tetmarch_testing_LightsOfRenderer_h
#define tetmarch_testing_LightsOfRenderer_h

#include "Light/Lighting.h"

#include "Shot.h"

#include "vtkLight.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <gtest/gtest.h>

namespace tetmarch::testing
{
class LightsOf : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Property->ShadeOn();
    this->Renderer->SetActiveCamera(this->Camera);
    this->Camera->SetPosition(1.0, 2.0, 8.0);
    this->Camera->SetFocalPoint(1.0, 2.0, 3.0);
    this->Camera->SetViewUp(0.0, 1.0, 0.0);
  }

  vtkSmartPointer<vtkLight> add()
  {
    auto light = vtkSmartPointer<vtkLight>::New();
    this->Renderer->AddLight(light);
    return light;
  }

  /// As at the begin of a frame.
  Lighting lighting()
  {
    this->Renderer->UpdateLightsGeometryToFollowCamera();
    return lightingOf(this->Renderer, this->Property);
  }

  /// Of a renderer with one light that counts.
  LightSource only()
  {
    const Lighting lighting = this->lighting();
    EXPECT_EQ(lighting.Lights.size(), 1u);
    return lighting.Lights.empty() ? LightSource{} : lighting.Lights.front();
  }

  vtkNew<WindowlessRenderer> Renderer;
  vtkNew<vtkCamera> Camera;
  vtkNew<vtkVolumeProperty> Property;
};

inline void expectNear(const std::array<double, 3>& found, double x, double y, double z)
{
  EXPECT_NEAR(found[0], x, 1e-12);
  EXPECT_NEAR(found[1], y, 1e-12);
  EXPECT_NEAR(found[2], z, 1e-12);
}
} // namespace tetmarch::testing

#endif
