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
#include "GLObjects.h"
#include "Scene.h"
#include "WatchedMapper.h"

#include "vtkLogger.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"

#include <functional>
#include <gtest/gtest.h>
#include <iostream>
#include <utility>

namespace tetmarch::testing
{
/// SceneType is Scene or a class derived from it. A derived fixture adds to the scene, and calls
/// lookOnce() at the end of its constructor.
template <typename SceneType>
class FaultScene : public ::testing::Test
{
protected:
  static constexpr int Side = 64;

  FaultScene()
  {
    this->Shown.Renderer->SetBackground(0.2, 0.4, 0.6);
    this->Mapper->SetInputData(this->Shown.Data);
    this->Mapper->SetShaderStageToFragment(); // on every GPU: other stages meet other faults
    this->Shown.Volume->SetMapper(this->Mapper);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // VTK itself complains of faults, too
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

  // Releases what the mapper has on the GPU, and the shaders of the window if asked for.
  void release(bool shadersToo)
  {
    this->Mapper->ReleaseGraphicsResources(this->Shown.Window);
    if (shadersToo)
    {
      this->window()->GetShaderCache()->ReleaseGraphicsResources(this->Shown.Window);
    }
  }

  // Draws one frame in which each draw of the mapper meets the fault; whether it happened.
  template <typename... Arguments>
  bool meet(Arguments&&... arguments)
  {
    return this->meetIn([this] { this->Shown.Window->Render(); }, arguments...);
  }
  // The same for anything else that has the mapper draw.
  template <typename... Arguments>
  bool meetIn(const std::function<void()>& act, Arguments&&... arguments)
  {
    bool happened = false;
    this->Mapper->Around = [&](const std::function<void()>& draw)
    {
      const FaultyGL faulty(arguments...);
      draw();
      happened = happened || faulty.happened();
    };
    act();
    this->Mapper->Around = nullptr;
    return happened;
  }

  struct EveryCall
  {
    Fault Kind;
    int Ending = 1;       ///< minimum number of calls that end the frame
    bool IsAgain = false; ///< also draws a third frame, after all has been released
    bool InParts = false; ///< parts of the volume without a fault are seen
  };
  // Lets each call of that kind fail that a frame makes after `prepare`, one call a frame.
  void expectEveryCallIsMet(const EveryCall& of, const std::function<void()>& prepare)
  {
    prepare();
    const auto objects = countGLObjects();
    const int shaders = countShaders();
    int calls = 0;
    int errors = 0;
    for (; calls < 1000; ++calls)
    {
      SCOPED_TRACE(std::string(nameOf(of.Kind)) + ", call " + std::to_string(calls));
      this->Watch.Errors.clear();
      const bool met = this->meet(of.Kind, calls);
      const Image frame = this->Shown.frame();
      if (!met)
      {
        this->expectSound(frame);
        break;
      }
      ASSERT_TRUE(of.InParts || this->Watch.Errors.size() <= 1u);
      if (this->Watch.Errors.empty())
      {
        // The frame can do without the refused call: that of fma, or of the end of a window.
        EXPECT_LE(compare(frame, this->Sound).Max, 2.0 / 255.0);
      }
      else
      {
        EXPECT_TRUE(of.InParts || frame.Rgba == this->Empty.Rgba);
        ++errors;
      }
      // At once, and after everything of it is gone.
      EXPECT_LE(compare(this->frame(), this->Sound).Max, 2.0 / 255.0);
      EXPECT_TRUE(of.InParts || this->Watch.Errors.size() <= 1u);
      prepare();
      EXPECT_EQ(countGLObjects(), objects);
      EXPECT_LE(countShaders(), shaders);
      if (of.IsAgain)
      {
        this->expectSound(this->frame());
        prepare();
      }
    }
    EXPECT_GE(errors, of.Ending) << nameOf(of.Kind);
    std::cout << "[ MEASURED ] " << nameOf(of.Kind) << ": " << calls << " calls, " << errors
              << " of them end the frame\n";
  }

  // Replaces these words in the shaders of two frames: there is one error, which says the others.
  void expectSpoiltShader(const char* words, const char* said)
  {
    const auto spoil = [words](const std::string& text) { return spoilt(text, words); };
    this->Watch.Errors.clear();
    for (int i = 0; i < 2; ++i)
    {
      this->release(true);
      EXPECT_TRUE(this->meet(spoil));
      this->expectEmpty(this->Shown.frame());
    }
    this->expectReported(said);
    this->expectSound(this->frame());
    EXPECT_EQ(this->Watch.Errors.size(), 1u);
  }

  // The text with the words replaced, so that no GL compiles it; texts without them stay.
  static std::string spoilt(const std::string& text, const std::string& words)
  {
    const std::size_t at = text.find(words);
    std::string result = text;
    return at == std::string::npos ? text : result.replace(at, words.size(), "1");
  }

  void expectReported(const char* words)
  {
    ASSERT_EQ(this->Watch.Errors.size(), 1u);
    EXPECT_NE(this->Watch.Errors[0].find(words), std::string::npos) << this->Watch.Errors[0];
  }

  SceneType Shown{ latticeWithHole(6, 0.15, 1, sineField()), Side, Side };
  vtkNew<WatchedMapper> Mapper;
  ErrorWatch Watch{ this->Mapper };
  Image Sound;
  Image Empty;
};
} // namespace tetmarch::testing

#endif
