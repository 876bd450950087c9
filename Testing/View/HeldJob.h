// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef tetmarch_HeldJob_h
#define tetmarch_HeldJob_h

#include "Loader.h"

#include <condition_variable>
#include <mutex>

namespace tetmarch
{

/// Holds jobs that begin while it lives, in their own threads, at a step of a stage, until they are
/// let go. So what comes meanwhile comes during the job, however fast or slow the machine is.
class HeldJob
{
public:
  /// At the first step of that stage whose fraction is larger.
  HeldJob(Loader& loader, const std::string& stage, double above)
  {
    loader.SetWatch(
      [state = this->Shared, stage, above](const std::string& at, double fraction)
      {
        std::unique_lock<std::mutex> lock(state->Mutex);
        if (at == stage && fraction > above && !state->LetGo)
        {
          state->Holds = true;
          state->Changed.wait(lock, [&] { return state->LetGo; });
        }
      });
  }
  ~HeldJob() { this->LetGo(); }
  HeldJob(const HeldJob&) = delete;
  HeldJob& operator=(const HeldJob&) = delete;

  /// Whether a job is held now.
  bool Holds()
  {
    const std::lock_guard<std::mutex> lock(this->Shared->Mutex);
    return this->Shared->Holds && !this->Shared->LetGo;
  }

  void LetGo()
  {
    const std::lock_guard<std::mutex> lock(this->Shared->Mutex);
    this->Shared->LetGo = true;
    this->Shared->Changed.notify_all();
  }

private:
  struct State
  {
    std::mutex Mutex;
    std::condition_variable Changed;
    bool Holds = false;
    bool LetGo = false;
  };

  std::shared_ptr<State> Shared = std::make_shared<State>();
};

} // namespace tetmarch

#endif
