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
  void BadSessionsAreRefused();
  void WhatIsSavedDrawsTheSamePicture_data();
  void WhatIsSavedDrawsTheSamePicture();
  void OddNamesAreQuoted();

private:
  /// Takes the picture that is shown, in which there is something.
  void TakePicture();
  /// By a session in a new window, by tetmarch-render, and by Python; each draws that picture.
  void CheckSession();
  void CheckCommand();
  void CheckScript();
  void CheckSame(const QString& path);

  Pixels Shown;
};

} // namespace tetmarch

#endif
