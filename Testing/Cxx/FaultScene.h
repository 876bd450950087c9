// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A scene whose volume meets faults of the GL, and how it looks with and without it
 */
#ifndef tetmarch_testing_FaultScene_h
#define tetmarch_testing_FaultScene_h

#include "ErrorWatch.h"
#include "FaultyGL.h"
#include "Scene.h"
#include "WatchedMapper.h"

#include "vtkLogger.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"

#include <functional>
#include <gtest/gtest.h>
#include <utility>

namespace tetmarch::testing
{
/// SceneType is Scene or a class derived from it. Who derives from this adds to the scene, and ends
/// its constructor with lookOnce().
template <typename SceneType>
class FaultScene : public ::testing::Test
{
protected:
  static constexpr int Side = 64;

  FaultScene()
  {
    this->Shown.Renderer->SetBackground(0.2, 0.4, 0.6);
    this->Mapper->SetInputData(this->Shown.Data);
    this->Shown.Volume->SetMapper(this->Mapper);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // for what VTK says itself
  }
  ~FaultScene() override
  {
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_INFO);
    this->Shown.Volume->SetMapper(this->Shown.Mapper);
  }

  void lookOnce()
  {
    this->Sound = this->frame();
    this->Shown.Volume->VisibilityOff();
    this->Empty = this->frame();
    this->Shown.Volume->VisibilityOn();
    EXPECT_GT(compare(this->Sound, this->Empty).Max, 0.1);
  }

  vtkOpenGLRenderWindow* window()
  {
    return vtkOpenGLRenderWindow::SafeDownCast(this->Shown.Window);
  }

  Image frame()
  {
    this->Shown.Window->Render();
    return this->Shown.frame();
  }
  void expectEmpty(const Image& frame) { EXPECT_EQ(frame.Rgba, this->Empty.Rgba); }
  void expectSound(const Image& frame) { EXPECT_EQ(frame.Rgba, this->Sound.Rgba); }

  // Of the mapper, and the shaders of the window.
  void release(bool shadersToo)
  {
    this->Mapper->ReleaseGraphicsResources(this->Shown.Window);
    if (shadersToo)
    {
      this->window()->GetShaderCache()->ReleaseGraphicsResources(this->Shown.Window);
    }
  }

  // One frame, of which the mapper's part meets the fault.
  template <typename... Arguments>
  bool meet(Arguments&&... arguments)
  {
    bool happened = false;
    this->Mapper->Around = [&](const std::function<void()>& draw)
    {
      const FaultyGL faulty(std::forward<Arguments>(arguments)...);
      draw();
      happened = faulty.happened();
    };
    this->Shown.Window->Render();
    this->Mapper->Around = nullptr;
    return happened;
  }

  SceneType Shown{ latticeWithHole(6, 0.15, 1, sineField()), Side, Side };
  vtkNew<WatchedMapper> Mapper;
  ErrorWatch Watch{ this->Mapper };
  Image Sound;
  Image Empty;
};
} // namespace tetmarch::testing

#endif
