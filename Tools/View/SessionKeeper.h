// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Keeps the session of a window when data have been drawn and before others are read, since readers
 * crash on some files; offers what a crashed program has kept.
 */
#ifndef tetmarch_SessionKeeper_h
#define tetmarch_SessionKeeper_h

#include "KeptSession.h"

#include <QObject>

class QToolBar;

namespace tetmarch
{
class MainWindow;

class SessionKeeper : public QObject
{
  Q_OBJECT

public:
  /// The window must outlive this object. If there is something to offer, a bar in it does so.
  SessionKeeper(MainWindow& window, const QString& folder);

  /// The folder of this user.
  static QString GetFolder();
  /// Null: nothing is offered.
  QToolBar* GetOffer() { return this->Offer; }

private:
  void Keep();
  void MakeOffer();
  void Restore();
  /// Data that are new have been drawn.
  void TakeShown();
  void EndOffer();

  MainWindow& Window;
  KeptSession Kept;
  std::unique_ptr<AbandonedSession> Abandoned;
  QToolBar* Offer = nullptr;
  bool IsNew = false; // what is shown was not drawn yet
  bool Restoring = false;
  bool Warned = false;
};

} // namespace tetmarch

#endif
