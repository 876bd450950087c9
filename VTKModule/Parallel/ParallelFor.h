// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Parallel loops that pass on exceptions.
#ifndef TetMarchParallelParallelFor_h
#define TetMarchParallelParallelFor_h

#include "vtkType.h"

#include <type_traits>

namespace tetmarch
{

/** The number of threads of the loops below; at least 1. */
int numberOfThreads();

/** A type-erased loop body, called for each part of its range. */
using CallLoop = void (*)(void* loop, vtkIdType first, vtkIdType last);

/** parallelFor() without the type of the loop, so that vtkSMPTools is compiled once. */
void forParts(vtkIdType begin, vtkIdType end, vtkIdType grain, CallLoop call, void* loop);

/**
 * Call f(first, last) in threads for parts of begin..end, as vtkSMPTools::For() does. The first
 * exception of a call ends the loop and is rethrown to the caller: VTK's back end STDThread would
 * swallow it, and the arrays that the loop fills would seem complete.
 */
template <typename Functor>
void parallelFor(vtkIdType begin, vtkIdType end, vtkIdType grain, Functor&& f)
{
  using Loop = std::remove_reference_t<Functor>;
  const auto call = [](void* loop, vtkIdType first, vtkIdType last)
  { (*static_cast<Loop*>(loop))(first, last); };
  forParts(begin, end, grain, call, const_cast<std::remove_const_t<Loop>*>(&f));
}

/** The same with a part size chosen by the back end. */
template <typename Functor>
void parallelFor(vtkIdType begin, vtkIdType end, Functor&& f)
{
  parallelFor(begin, end, 0, f);
}

} // namespace tetmarch

#endif
