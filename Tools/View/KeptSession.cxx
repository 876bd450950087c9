// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "KeptSession.h"

#include "Failure.h"
#include "ViewStateJson.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <QUuid>

namespace
{
// A lock is stale when its program has ended, not after some time.
std::unique_ptr<QLockFile> MakeLock(const QString& path)
{
  auto lock = std::make_unique<QLockFile>(path + QStringLiteral(".lock"));
  lock->setStaleLockTime(0);
  return lock;
}
} // namespace

namespace tetmarch
{

// The number of a process comes again, and in a folder of two machines it isn't the only one.
KeptSession::KeptSession(const QString& folder)
  : Path(folder + QLatin1Char('/') + QString::number(QCoreApplication::applicationPid()) +
         QLatin1Char('-') + QUuid::createUuid().toString(QUuid::Id128) + QStringLiteral(".json"))
  , Lock(MakeLock(this->Path))
{
  QDir().mkpath(folder);
}

KeptSession::~KeptSession()
{
  QFile::remove(this->Path); // before the lock is gone
}

bool KeptSession::Keep(const ViewState& state)
{
  if (!this->Lock->isLocked() && !this->Lock->tryLock())
  {
    return false;
  }
  const QByteArray text = QByteArray::fromStdString(WriteState(state));
  QSaveFile file(this->Path);
  return file.open(QIODevice::WriteOnly) && file.write(text) == text.size() && file.commit();
}

std::unique_ptr<AbandonedSession> FindAbandonedSession(const QString& folder)
{
  const QFileInfoList files =
    QDir(folder).entryInfoList({ QStringLiteral("*.json") }, QDir::Files, QDir::Time);
  for (const QFileInfo& file : files)
  {
    auto lock = MakeLock(file.filePath());
    if (!lock->tryLock())
    {
      continue;
    }
    try
    {
      const ViewState state = LoadSession(file.filePath().toStdString());
      return std::make_unique<AbandonedSession>(
        AbandonedSession{ file.filePath(), file.lastModified(), state, std::move(lock) });
    }
    catch (const Failure&)
    {
      QFile::remove(file.filePath());
    }
  }
  return nullptr;
}

} // namespace tetmarch
