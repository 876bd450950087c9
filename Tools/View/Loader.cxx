// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Loader.h"

#include "Failure.h"

#include <QCoreApplication>
#include <QMetaObject>
#include <QPointer>

#include <algorithm>
#include <new>

namespace tetmarch
{

/// One job with its thread. The thread writes Result and Failed before it posts Take().
struct Loader::Run
{
  LoadJob Job;
  Watch Watching;
  std::atomic<bool> Stop{ false };
  std::shared_ptr<LoadResult> Result;
  QString Failed;
  std::thread Thread;
};

Loader::Loader(QObject* parent)
  : QObject(parent)
{
}

Loader::~Loader()
{
  this->Cancel();
  for (const auto& run : this->Stopping)
  {
    run->Thread.join();
  }
}

void Loader::Start(const LoadJob& job)
{
  this->Cancel();
  auto run = std::make_shared<Run>();
  run->Job = job;
  run->Watching = this->Watching;
  this->Current = run;
  const auto work = [this, run]
  {
    const ProgressReport report = [this, run](const std::string& stage, double fraction)
    {
      if (!run->Stop)
      {
        QMetaObject::invokeMethod(this,
          [this, run, stage, fraction]
          {
            if (run == this->Current)
            {
              Q_EMIT this->Progressed(QString::fromStdString(stage), fraction);
            }
          });
      }
      if (run->Watching)
      {
        run->Watching(stage, fraction);
      }
      return !run->Stop;
    };
    try
    {
      run->Result = std::make_shared<LoadResult>(RunJob(run->Job, report));
    }
    catch (const std::bad_alloc&)
    {
      run->Failed = QStringLiteral("there is too little memory for '%1'")
                      .arg(QString::fromStdString(run->Job.Wanted.File));
    }
    catch (const std::exception& error)
    {
      run->Failed = QString::fromStdString(error.what());
    }
    // This object joins the thread before it ends, so it is still there.
    QMetaObject::invokeMethod(this, [this, run] { this->Take(run); });
  };
  run->Thread = std::thread(work);
}

void Loader::Cancel()
{
  if (this->Current)
  {
    this->Current->Stop = true;
    this->Stopping.push_back(std::move(this->Current));
    this->Current = nullptr;
  }
}

void Loader::Take(const std::shared_ptr<Run>& run)
{
  run->Thread.join();
  const auto stopping = std::find(this->Stopping.begin(), this->Stopping.end(), run);
  if (stopping != this->Stopping.end())
  {
    this->Stopping.erase(stopping);
    return;
  }
  this->Current = nullptr;
  Q_EMIT this->Finished(run->Result, run->Failed);
}

} // namespace tetmarch
