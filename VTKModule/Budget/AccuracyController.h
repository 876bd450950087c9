// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// With which accuracy a frame is drawn: what the user set, or what keeps the user's budgets.
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
  bool Drawn = false;    // to its end
  bool IsPicture = true; // else a view, whose time tells nothing of a picture's
  bool OnlyDrawn = true; // no stage ran, and no shader was new
  double Seconds = 0;
  double ErrorBound = 0; // greatest of a pixel; 0: not looked at
  Fingerprint Subject;   // what was drawn, apart from camera and accuracy, at which size
};

class AccuracyController
{
public:
  /** The level to draw the next frame with. */
  AccuracyLevel begin(const AccuracyOptions& options);
  void end(const FrameResult& frame);

  /** Of the last frame that was drawn. */
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
