// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The time of a stage's last run, and its number of runs.
#ifndef TetMarchCachingStageRecord_h
#define TetMarchCachingStageRecord_h

#include <chrono>
#include <cstdint>

namespace tetmarch
{

struct StageRecord
{
  double Seconds = 0; // of the last run
  std::int64_t Runs = 0;
};

/** Adds a run to a record when the scope ends. */
class StageRecorder
{
public:
  explicit StageRecorder(StageRecord& record)
    : Record(record)
    , Begin(std::chrono::steady_clock::now())
  {
  }
  ~StageRecorder()
  {
    this->Record.Seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Begin).count();
    ++this->Record.Runs;
  }
  StageRecorder(const StageRecorder&) = delete;
  StageRecorder& operator=(const StageRecorder&) = delete;

private:
  StageRecord& Record;
  std::chrono::steady_clock::time_point Begin;
};

} // namespace tetmarch

#endif
