// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Parallel/ParallelFor.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>

namespace tetmarch
{
namespace
{

// Keeps the first exception of several threads.
class FirstException
{
public:
  // Run work, or skip it if some thread has thrown already. Throws nothing.
  template <typename Work>
  void guard(Work&& work) noexcept
  {
    if (this->Thrown)
    {
      return;
    }
    try
    {
      work();
    }
    catch (...)
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      if (!this->Thrown)
      {
        this->First = std::current_exception();
        this->Thrown = true;
      }
    }
  }

  // Rethrow the exception, if any; the threads have ended.
  void rethrow() const
  {
    if (this->First)
    {
      std::rethrow_exception(this->First);
    }
  }

private:
  std::atomic<bool> Thrown{ false };
  std::mutex Mutex;
  std::exception_ptr First;
};

} // namespace

int numberOfThreads() { return std::max(vtkSMPTools::GetEstimatedNumberOfThreads(), 1); }

void forParts(vtkIdType begin, vtkIdType end, vtkIdType grain, CallLoop call, void* loop)
{
  FirstException exception;
  vtkSMPTools::For(begin, end, grain,
    [&](vtkIdType first, vtkIdType last) { exception.guard([&] { call(loop, first, last); }); });
  exception.rethrow();
}

} // namespace tetmarch
