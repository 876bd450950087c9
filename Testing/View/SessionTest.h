// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef tetmarch_SessionTest_h
#define tetmarch_SessionTest_h

#include "ViewCase.h"

namespace tetmarch
{

/// What a view is saved and copied as draws the same picture, to the last bit.
class SessionTest : public ViewCase
{
  Q_OBJECT

private Q_SLOTS:
  void AStateComesBackFromItsText();
  void BadSessionsAreRefused_data();
  void BadSessionsAreRefused();
  void ASessionDrawsTheSamePicture_data();
  void ASessionDrawsTheSamePicture();
  void TheCommandLineDrawsTheSamePicture_data();
  void TheCommandLineDrawsTheSamePicture();
  void OddNamesAreQuoted();
  void TheScriptDrawsTheSamePicture_data();
  void TheScriptDrawsTheSamePicture();

private:
  /// A scene that differs in everything from how a file is shown first.
  void OpenScene();
  /// By tetmarch-render, and by Python; each draws what the window does.
  void CheckCommand();
  void CheckScript();
};

} // namespace tetmarch

#endif
