// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef tetmarch_CrashTest_h
#define tetmarch_CrashTest_h

#include "SessionKeeper.h"
#include "ViewCase.h"

namespace tetmarch
{

/// What is left of a session if the program dies, and what the next one does with it.
class CrashTest : public ViewCase
{
  Q_OBJECT

public:
  /// A program with a session, whose picture it saves. Then it reads a file, says so, and waits to
  /// be killed.
  static int ReadUntilKilled(const QString& folder);

private Q_SLOTS:
  void AKilledProgramsSessionIsRestored();
  void ANormalEndLeavesNothing();
  void OneWindowOffersIt();
  void AnOfferIsDiscarded();
  void AnOfferLetsAFileBeOpened();
  void ASessionThatFailsIsOfferedAgain();
  void WhatIsNoSessionIsNotOffered();
  void AFolderThatIsNotWrittenTo();

private:
  /// A new folder with one session that nobody owns: of a scan, as if it were in that file.
  QString AbandonSession(const char* data);
  void Press(SessionKeeper& keeper, const char* button);
};

} // namespace tetmarch

#endif
