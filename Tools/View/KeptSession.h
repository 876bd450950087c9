// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Sessions that outlive a crash: each running program has a file of its own in one folder, locked
 * as long as the program lives, and removes it at its end.
 */
#ifndef tetmarch_KeptSession_h
#define tetmarch_KeptSession_h

#include "ViewState.h"

#include <QDateTime>
#include <QLockFile>
#include <QString>

#include <memory>

namespace tetmarch
{

/// The file of this program.
class KeptSession
{
public:
  /// The folder is made if there is none.
  explicit KeptSession(const QString& folder);
  /// Removes the file.
  ~KeptSession();
  KeptSession(const KeptSession&) = delete;
  KeptSession& operator=(const KeptSession&) = delete;

  /// Takes the place of what was kept. Returns false if it can't be written; that stays then.
  bool Keep(const ViewState& state);
  const QString& GetPath() const { return this->Path; }

private:
  QString Path;
  std::unique_ptr<QLockFile> Lock;
};

/// A file that no living program owns. It is locked as long as this object lives.
struct AbandonedSession
{
  QString Path;
  QDateTime Time; // when it was kept
  ViewState State;
  std::unique_ptr<QLockFile> Lock;
};

/// The newest one in the folder; null: none. Those that are no sessions are removed.
std::unique_ptr<AbandonedSession> FindAbandonedSession(const QString& folder);

} // namespace tetmarch

#endif
