// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Chooses the accuracy of a frame: as set by the user, or such that the user's budgets are kept.
#ifndef TetMarchBudgetAccuracyController_h
#define TetMarchBudgetAccuracyController_h

#include "Budget/AccuracyLadder.h"
#include "Budget/LevelController.h"
#include "Caching/Fingerprint.h"

namespace tetmarch
{

/** The result of a frame. */
struct FrameResult
{
  bool Drawn = false;    // completely
  bool IsPicture = true; // false: a view, whose time is not that of a picture
  bool OnlyDrawn = true; // no stage ran, and no shader was compiled
  double Seconds = 0;
  double ErrorBound = 0;      // maximum over the pixels; 0: not measured
  Fingerprint ContentVersion; // of the scene and size, without camera and accuracy
  double PixelTolerance = 0;  // with which the picture was drawn; 0: a ray for each pixel
};

class AccuracyController
{
public:
  /** The level of the next frame. */
  Rung begin(const AccuracyOptions& options);
  void end(const FrameResult& frame);

  /** The level of the last frame, with the PixelTolerance that it had. */
  const Rung& used() const { return this->Used; }
  /** Whether the last frame was completed and kept its budgets. */
  bool isKept() const { return this->Kept; }

private:
  AccuracyOptions Options;
  std::vector<Rung> Ladder;
  LevelController Choice;
  Fingerprint ContentVersion; // of the last drawn frame
  Rung Used;
  bool Kept = false;
};

} // namespace tetmarch

#endif
