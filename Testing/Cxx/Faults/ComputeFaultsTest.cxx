// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whatever the GL refuses of compute shaders, and a GL that has none.
#include "FaultScene.h"
#include "GLPointers.h"
#include "Held.h"

#include "vtkActor.h"

namespace
{
using namespace tetmarch::testing;

class ComputeFaults : public FaultScene<Scene>
{
protected:
  ComputeFaults()
  {
    this->Shown.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 0.8, 0.2 }));
    this->lookOnce();
    this->Mapper->SetShaderStageToCompute();
  }
};

// Two mappers of a window share their programs, and the last one takes them away.
TEST_F(ComputeFaults, ProgramsAreSharedAndReleased)
{
  this->frame();
  const int shaders = countShaders();
  vtkNew<vtkTetMarchVolumeMapper> other;
  other->SetInputData(this->Shown.Data);
  other->SetShaderStageToCompute();
  vtkNew<vtkVolume> volume;
  volume->SetMapper(other);
  volume->SetProperty(this->Shown.property());
  this->Shown.Renderer->AddVolume(volume);
  this->frame();
  EXPECT_EQ(other->GetUsedShaderStage(), vtkTetMarchVolumeMapper::COMPUTE_STAGE);
  EXPECT_EQ(countShaders(), shaders);
  this->release(false);
  EXPECT_EQ(countShaders(), shaders);
  other->ReleaseGraphicsResources(this->Shown.Window);
  EXPECT_EQ(countShaders(), shaders - 1);
  this->Shown.Renderer->RemoveVolume(volume);
  this->expectSound(this->frame());
}

// As on macOS, which ended at OpenGL 4.1.
TEST_F(ComputeFaults, WithoutComputeShaders)
{
  const auto before = TETMARCH_GL_POINTER(DispatchCompute);
  this->release(false); // what the GL has is asked once
  TETMARCH_GL_POINTER(DispatchCompute) = nullptr;
  this->expectEmpty(this->frame());
  this->expectReported("OpenGL 4.3");
  this->Mapper->SetShaderStageToAutomatic();
  this->expectSound(this->frame());
  TETMARCH_GL_POINTER(DispatchCompute) = before;
}
} // namespace
