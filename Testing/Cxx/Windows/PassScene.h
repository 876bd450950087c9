// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A scene that is drawn by one render pass or another
 */
#ifndef tetmarch_testing_PassScene_h
#define tetmarch_testing_PassScene_h

#include "BlendedFrame.h"

#include "vtkActor.h"
#include "vtkRenderPass.h"

namespace tetmarch::testing
{
/// A lattice over a background, with a ball in it if told so.
class PassScene : public ::testing::Test
{
protected:
  static constexpr int Side = 120;

  PassScene()
  {
    this->Shown.Renderer->SetBackground(0.2, 0.4, 0.6);
    this->Shown.property()->SetScalarOpacityUnitDistance(0.5);
  }

  void addBall()
  {
    this->Shown.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 0.8, 0.2 }));
  }

  /// With the pass, or without any.
  Image frame(vtkRenderPass* pass = nullptr)
  {
    this->Shown.Renderer->SetPass(pass);
    this->Shown.Window->Render();
    return this->Shown.frame();
  }

  Scene Shown{ jitteredLattice(8, 0.15, 1, sineField()), Side, Side };
};
} // namespace tetmarch::testing

#endif
