// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whatever the GL refuses of the effects of light: one error that says what, a frame without the
// volume, nothing left behind, and the volume is back as soon as the GL takes it.
#include "FaultScene.h"
#include "LitScene.h"

#include "vtkActor.h"

#include <functional>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

class EffectFaults : public FaultScene<LitScene>
{
protected:
  EffectFaults()
  {
    this->Shown.addGradientOpacity();
    this->Mapper->SetShadowMethodToAtVertices();
    this->lookOnce();
  }
};

// All else is on the GPU already when the GL refuses room for these shadows.
TEST_F(EffectFaults, NoRoomForShadowsOfOpaqueGeometry)
{
  this->Shown.Renderer->AddActor(makeBall({ 9.0, 12.0, 4.5 }, 0.5, { 1.0, 1.0, 1.0 }));
  this->Sound = this->frame();
  const vtkTypeInt64 bytes = this->Mapper->GetGPUMemoryBytes();
  this->Mapper->OpaqueShadowsOn();
  for (const Fault fault : { Fault::BufferData, Fault::TexBuffer })
  {
    EXPECT_TRUE(this->meet(fault, 0));
    this->expectEmpty(this->Shown.frame());
    EXPECT_EQ(this->Mapper->GetGPUMemoryBytes(), bytes);
  }
  ASSERT_EQ(this->Watch.Errors.size(), 2u);
  EXPECT_NE(this->Watch.Errors[0].find("no room for a buffer of"), std::string::npos);
  EXPECT_GT(compare(this->frame(), this->Sound).Max, 0.0);
  this->Mapper->OpaqueShadowsOff();
  this->expectSound(this->frame());
}

// Before the shader of these shadows is even compiled.
TEST_F(EffectFaults, NoRoomForTheJitter)
{
  const vtkTypeInt64 bytes = this->Mapper->GetGPUMemoryBytes();
  this->Mapper->SetShadowMethodToAlongRays();
  for (int i = 0; i < 2; ++i)
  {
    EXPECT_TRUE(this->meet(Fault::TexImage, 0));
    this->expectEmpty(this->Shown.frame());
  }
  this->expectReported("no room for a texture of 64 x 64 numbers");
  this->Mapper->SetShadowMethodToAtVertices();
  this->expectSound(this->frame());
  EXPECT_EQ(this->Mapper->GetGPUMemoryBytes(), bytes);
}
} // namespace
