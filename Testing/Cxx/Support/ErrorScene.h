// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A scene that is spoilt and mended: errors come once, and nothing remains of them
 */
#ifndef tetmarch_testing_ErrorScene_h
#define tetmarch_testing_ErrorScene_h

#include "ErrorWatch.h"
#include "Scene.h"

#include <functional>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace tetmarch::testing
{
using Words = std::vector<std::string>;

/// Of a Scene or a SmartScene.
template <typename SceneType>
class ErrorsIn : public ::testing::Test
{
protected:
  static constexpr int Side = 64;

  explicit ErrorsIn(decltype(SceneType::Data) sound)
    : Shown(sound, Side, Side)
  {
    this->Shown.Renderer->SetBackground(0.2, 0.4, 0.6);
    this->Sound = this->frame();
    this->Shown.Volume->VisibilityOff();
    this->Empty = this->frame();
    this->Shown.Volume->VisibilityOn();
    EXPECT_GT(compare(this->Sound, this->Empty).Max, 0.1);
  }

  Image frame()
  {
    this->Shown.Window->Render();
    return framePictureOf(this->Shown.Window);
  }

  void expectEmpty() { EXPECT_EQ(compare(this->frame(), this->Empty).Max, 0.0); }
  void expectSound() { EXPECT_EQ(compare(this->frame(), this->Sound).Max, 0.0); }

  /// Nothing is drawn, and there is no error.
  void expectEmptyWithoutErrors()
  {
    const ErrorWatch watch(this->Shown.Mapper);
    this->expectEmpty();
    EXPECT_EQ(watch.Errors, Words());
    EXPECT_EQ(watch.Warnings, Words());
  }
  /// The same, but a warning says that nothing is visible.
  void expectNothingVisible()
  {
    const ErrorWatch watch(this->Shown.Mapper);
    this->expectEmpty();
    EXPECT_EQ(watch.Errors, Words());
    ASSERT_EQ(watch.Warnings.size(), 1u);
    EXPECT_NE(watch.Warnings[0].find("Nothing is visible"), std::string::npos);
  }

  /// The bad input gives one error that says these words, once until it has been put right.
  void expectError(
    const std::function<void()>& spoil, const std::function<void()>& mend, const Words& words)
  {
    ErrorWatch watch(this->Shown.Mapper);
    for (std::size_t round = 1; round <= 2; ++round)
    {
      spoil();
      for (int i = 0; i < 3; ++i)
      {
        this->expectEmpty();
        ASSERT_EQ(watch.Errors.size(), round);
      }
      for (const std::string& word : words)
      {
        EXPECT_NE(watch.Errors.back().find(word), std::string::npos)
          << '"' << word << "\" is not in: " << watch.Errors.back();
      }
      mend();
      this->expectSound();
      EXPECT_EQ(watch.Errors.size(), round);
    }
  }

  void show(vtkDataObject* data) { this->Shown.Mapper->SetInputDataObject(data); }
  void showSound() { this->show(this->Shown.Data); }

  SceneType Shown;
  Image Sound;
  Image Empty;
};

class ErrorScene : public ErrorsIn<Scene>
{
public:
  static Grid soundGrid() { return jitteredLattice(4, 0.15, 1, sineField()); }

protected:
  ErrorScene()
    : ErrorsIn(soundGrid())
  {
  }
};
} // namespace tetmarch::testing

#endif
