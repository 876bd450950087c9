// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Progress and cancellation of long work.
#ifndef TetMarchParallelProgress_h
#define TetMarchParallelProgress_h

#include "Parallel/ParallelFor.h"

#include "vtkType.h"

#include <algorithm>
#include <functional>

namespace tetmarch
{

/** Called from the main thread with the completed share, 0..1; false requests a stop. */
using Progress = std::function<bool(double)>;

/** Progress of a part of longer work: its share 0..1 becomes `begin` to `end`. */
inline Progress subProgress(const Progress& whole, double begin, double end)
{
  return [=](double share) { return !whole || whole(begin + (end - begin) * share); };
}

/** Call f(first, last) in parallel over portions of 0..count, and report progress between them.
 * Returns false if a stop was requested. */
template <typename Functor>
bool parallelFor(vtkIdType count, const Progress& progress, Functor&& f)
{
  const vtkIdType portion = std::max<vtkIdType>(count / 8 + 1, 1 << 16);
  for (vtkIdType first = 0; first < count; first += portion)
  {
    const vtkIdType last = std::min(first + portion, count);
    parallelFor(first, last, std::max<vtkIdType>((last - first) / 64, 1024), f);
    if (progress && !progress(static_cast<double>(last) / static_cast<double>(count)))
    {
      return false;
    }
  }
  return true;
}

} // namespace tetmarch

#endif
