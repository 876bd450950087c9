// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// How a part of a frame ended: it is done, it stopped, or it failed.
#ifndef TetMarchCachingStageResult_h
#define TetMarchCachingStageResult_h

#include "Caching/WithinMemory.h"

#include <string>
#include <utility>

namespace tetmarch
{

struct StageResult
{
  std::string Error{};  // what is wrong and what to do; empty: nothing
  bool Stopped = false; // there is nothing to draw, or the user stopped the frame

  /** Whether the frame goes on. */
  bool isDone() const { return this->Error.empty() && !this->Stopped; }
  /** The result of the next part, which runs only if this one is done. */
  template <typename Next>
  StageResult then(Next&& next) const
  {
    return this->isDone() ? next() : *this;
  }
};

inline StageResult stoppedUnless(bool goesOn) { return { {}, !goesOn }; }

/** The result of stages, or that they lack memory. */
template <typename Stages>
StageResult guarded(Stages&& stages)
{
  StageResult result;
  std::string shortage = withinMemory("the frame", [&] { result = stages(); });
  return shortage.empty() ? result : StageResult{ std::move(shortage) };
}

} // namespace tetmarch

#endif
