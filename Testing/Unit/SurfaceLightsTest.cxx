// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The lights on the surfaces of a page.
#include "WebPage/SurfaceLights.h"

#include "Geometry/Vector3.h"
#include "Shot.h"

#include "vtkLight.h"
#include "vtkMatrix4x4.h"

#include <gtest/gtest.h>
#include <stdexcept>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

class SurfaceLights : public ::testing::Test
{
protected:
  vtkLight* add()
  {
    vtkNew<vtkLight> light;
    light->SetPosition(1.0, 2.0, 3.0);
    light->SetFocalPoint(1.0, 2.0, 1.0);
    light->SetColor(1.0, 0.5, 0.25);
    light->SetIntensity(2.0);
    this->Renderer->AddLight(light);
    return light;
  }

  SurfaceLight only()
  {
    this->Omissions.clear();
    const auto found = surfaceLights(this->Renderer, this->Omissions);
    EXPECT_TRUE(this->Omissions.empty());
    return found.size() == 1 ? found.front() : throw std::length_error("not one light");
  }

  std::size_t count() { return surfaceLights(this->Renderer, this->Omissions).size(); }

  vtkNew<WindowlessRenderer> Renderer;
  std::vector<std::string> Omissions;
};

TEST_F(SurfaceLights, AreAHeadlightIfVtkAddsOne)
{
  const SurfaceLight light = this->only();
  EXPECT_TRUE(light.FollowsCamera);
  EXPECT_EQ(light.Direction, (Vector3{ { 0.0, 0.0, -1.0 } }));
  EXPECT_EQ(light.Color, (Vector3{ { 1.0, 1.0, 1.0 } }));
  this->Renderer->AutomaticLightCreationOff();
  EXPECT_EQ(this->count(), 0u);
}

TEST_F(SurfaceLights, ShineInTheWorldOrWithTheCamera)
{
  vtkLight* light = this->add();
  EXPECT_FALSE(this->only().FollowsCamera);
  EXPECT_EQ(this->only().Direction, (Vector3{ { 0.0, 0.0, -2.0 } }));
  EXPECT_EQ(this->only().Color, (Vector3{ { 2.0, 1.0, 0.5 } }));
  vtkNew<vtkMatrix4x4> turn; // x to y, y to z, z to x
  turn->Zero();
  turn->SetElement(1, 0, 1.0);
  turn->SetElement(2, 1, 1.0);
  turn->SetElement(0, 2, 1.0);
  turn->SetElement(3, 3, 1.0);
  light->SetTransformMatrix(turn);
  EXPECT_EQ(this->only().Direction, (Vector3{ { -2.0, 0.0, 0.0 } }));
  light->SetLightTypeToCameraLight(); // whose matrix VTK sets to the camera's
  EXPECT_TRUE(this->only().FollowsCamera);
  EXPECT_EQ(this->only().Direction, (Vector3{ { 0.0, 0.0, -2.0 } }));
  light->SetLightTypeToHeadlight();
  EXPECT_EQ(this->only().Direction, (Vector3{ { 0.0, 0.0, -1.0 } }));
}

TEST_F(SurfaceLights, LeaveOutPositionalOnesAndTellIt)
{
  vtkLight* light = this->add();
  light->PositionalOn();
  EXPECT_EQ(this->count(), 0u);
  EXPECT_EQ(this->Omissions,
    (std::vector<std::string>{ "Lights (1) do not light the surfaces in the page: it has up to 8 "
                               "lights that are not positional." }));
  light->SwitchOff();
  this->Omissions.clear();
  this->add();
  EXPECT_EQ(this->count(), 1u);
  EXPECT_TRUE(this->Omissions.empty());
}
} // namespace
