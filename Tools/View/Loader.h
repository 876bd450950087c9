// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Jobs in a thread of their own, one after the other. A new job takes the place of one that runs.
 */
#ifndef tetmarch_Loader_h
#define tetmarch_Loader_h

#include "LoadJob.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <memory>
#include <thread>

namespace tetmarch
{

class Loader : public QObject
{
  Q_OBJECT

public:
  explicit Loader(QObject* parent = nullptr);
  /// Stops what runs, and waits for its end.
  ~Loader() override;

  void Start(const LoadJob& job);
  /// Nothing more is heard of what runs.
  void Cancel();
  bool IsBusy() const { return this->Current != nullptr; }
  /// Whether threads of jobs that were cancelled still run.
  bool IsStopping() const { return !this->Stopping.empty(); }

  /// Is called at each step of the jobs that begin from now on, in the thread of the job.
  using Watch = std::function<void(const std::string& stage, double fraction)>;
  void SetWatch(Watch watch) { this->Watching = std::move(watch); }

Q_SIGNALS:
  void Progressed(const QString& stage, double fraction);
  /// Of the job that was started last; result is empty after a failure.
  void Finished(std::shared_ptr<tetmarch::LoadResult> result, const QString& failure);

private:
  struct Run;

  void Take(const std::shared_ptr<Run>& run);

  Watch Watching;
  std::shared_ptr<Run> Current;
  std::vector<std::shared_ptr<Run>> Stopping;
};

} // namespace tetmarch

#endif
