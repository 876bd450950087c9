// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Decides the accuracy of a frame: what the user set, or what keeps the user's budgets.
#ifndef TetMarchBudgetAccuracyController_h
#define TetMarchBudgetAccuracyController_h

#include "Budget/AccuracyLadder.h"
#include "Budget/LevelController.h"
#include "Caching/Fingerprint.h"

namespace tetmarch
{

/** How a frame went. */
struct FrameResult
{
  bool Drawn = false;    // completely
  bool IsPicture = true; // false: a view, whose time says nothing about a picture
  bool OnlyDrawn = true; // no stage ran, and no shader was new
  double Seconds = 0;
  double ErrorBound = 0; // the greatest of all pixels; 0: not measured
  Fingerprint Subject;   // what was drawn, apart from camera and accuracy, at which size
};

class AccuracyController
{
public:
  /** The level to draw the next frame with. */
  AccuracyLevel begin(const AccuracyOptions& options);
  void end(const FrameResult& frame);

  /** What the last frame was drawn with. */
  const Rung& used() const { return this->Used; }
  /** Whether the last frame was drawn and kept the budgets that it had. */
  bool isKept() const { return this->Kept; }

private:
  AccuracyOptions Options;
  std::vector<Rung> Ladder;
  LevelController Choice;
  Fingerprint Subject; // of the last frame that was drawn
  Rung Used;
  bool Kept = false;
};

} // namespace tetmarch

#endif
