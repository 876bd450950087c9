// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Loops in threads that lose no exception.
#ifndef TetMarchParallelParallelFor_h
#define TetMarchParallelParallelFor_h

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <atomic>
#include <exception>
#include <mutex>

namespace tetmarch
{

/** Keeps the first exception of several threads. */
class FirstException
{
public:
  /** Run work, or skip it if some thread has thrown already. Throws nothing. */
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

  /** Throw what was kept, if anything; the threads have ended. */
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

/**
 * Call f(first, last) in threads for parts of begin..end, as vtkSMPTools::For() does. The first
 * exception that a call throws ends the loop and is thrown to the caller: VTK's back end STDThread
 * would swallow it, and the arrays that the loop fills would look complete.
 */
template <typename Functor>
void parallelFor(vtkIdType begin, vtkIdType end, vtkIdType grain, Functor&& f)
{
  FirstException exception;
  vtkSMPTools::For(begin, end, grain,
    [&](vtkIdType first, vtkIdType last) { exception.guard([&] { f(first, last); }); });
  exception.rethrow();
}

/** The same with parts as large as the back end chooses. */
template <typename Functor>
void parallelFor(vtkIdType begin, vtkIdType end, Functor&& f)
{
  parallelFor(begin, end, 0, f);
}

} // namespace tetmarch

#endif
