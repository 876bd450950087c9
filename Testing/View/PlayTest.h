// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef tetmarch_PlayTest_h
#define tetmarch_PlayTest_h

#include "ViewCase.h"

namespace tetmarch
{

/// What the user does with the picture and the panels.
class PlayTest : public ViewCase
{
  Q_OBJECT

private Q_SLOTS:
  void TheToleranceChangesTheStatistics();
  void EachSettingIsAPointOfThePlot();
  void TheGroundTruthTellsTheTrueError();
  void ABudgetIsKept();
  void EachEffectChangesThePicture();
  void TheCostOfAnEffectIsMeasured();
  void EachBlendModeAndViewIsDrawn();
  void CutsTakeSomethingAway();
  void AHandleOfTheBoxIsDragged();
  void TheLightIsDragged();
  void AClickFindsACell();
  void ADragTurnsAndIsExactAtItsEnd();
  void KeysLookAlongAxes();
};

} // namespace tetmarch

#endif
