// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The rows of a picture in parallel, in portions between which progress is told.
#ifndef TetMarchReferenceRowPortions_h
#define TetMarchReferenceRowPortions_h

#include "Parallel/ParallelFor.h"
#include "Parallel/Progress.h"

#include <algorithm>
#include <chrono>

namespace tetmarch
{

/** Call f(first, last) in parallel over portions of 0..rows. Portions begin with a row a thread and
 * grow as long as they take little time. Returns false if progress asked to stop. */
template <typename Functor>
bool forRows(vtkIdType rows, const Progress& progress, Functor&& f)
{
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds little(50);
  vtkIdType portion = progress ? numberOfThreads() : rows;
  for (vtkIdType first = 0; first < rows;)
  {
    const auto begin = Clock::now();
    const vtkIdType last = std::min(first + portion, rows);
    parallelFor(first, last, 1, f);
    if (progress && !progress(static_cast<double>(last) / static_cast<double>(rows)))
    {
      return false;
    }
    portion *= Clock::now() - begin < little ? 2 : 1;
    first = last;
  }
  return true;
}

} // namespace tetmarch

#endif
