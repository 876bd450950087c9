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
  /// A small lattice of hexahedra, at rest.
  void OpenLattice();
  /// Draws in the smallest tiles, so that a frame can be held between two of them.
  void MakeTiles();
  QPushButton* FindCancel();
  /// Calls it as soon as a frame, or a comparison, tells of its progress.
  void During(const std::function<void()>& what);

  bool Happened = false; // what During() was given
};

} // namespace tetmarch

#endif
