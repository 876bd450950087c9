// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Nothing blocks the window: neither preparing a mesh, nor a long frame, nor the ground truth.
 */
#ifndef tetmarch_AliveTest_h
#define tetmarch_AliveTest_h

#include "ViewCase.h"

#include <functional>

class QPushButton;

namespace tetmarch
{

class AliveTest : public ViewCase
{
  Q_OBJECT

private Q_SLOTS:
  void PreparesBesideTheWindow();
  void StopsPreparing();
  void CancelsPreparing();
  void ClosesWhileItPrepares();
  void KeepsTheMeshOfTimeSteps();
  void HandlesEventsDuringAFrame();
  void CancelsAFrame();
  void ASettingStopsTheFrame();
  void DataStopsTheFrame();
  void AScreenshotIsWhole();
  void AResizedWindowIsDrawnAnew();
  void ClosesDuringAFrame();
  void HandlesEventsDuringTheGroundTruth();
  void CancelsTheGroundTruth();

private:
  /// Draws in small tiles with much accuracy, so that a frame takes seconds.
  void MakeFramesLong();
  QPushButton* FindCancel();
  /// Calls it as soon as a frame, or a comparison, tells of its progress.
  void During(const std::function<void()>& what);
};

} // namespace tetmarch

#endif
