// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A cached result: it is made again when its input has changed, and freed when it is not needed.
#ifndef TetMarchCachingMadeFrom_h
#define TetMarchCachingMadeFrom_h

#include "Caching/Fingerprint.h"
#include "Caching/StageRecord.h"

namespace tetmarch
{

class MadeFrom
{
public:
  /** If the input differs from the last one, call free() and then, unless the input is empty,
   * make(). */
  template <typename Free, typename Make>
  void update(const Fingerprint& input, const Free& free, const Make& make)
  {
    if (input == this->Input)
    {
      return;
    }
    this->Input.clear();
    free();
    if (!input.empty())
    {
      StageRecorder recorder(this->Record);
      make();
    }
    this->Input = input;
  }
  void clear() { this->Input.clear(); }

  const Fingerprint& input() const { return this->Input; }
  const StageRecord& record() const { return this->Record; }

private:
  Fingerprint Input;
  StageRecord Record;
};

} // namespace tetmarch

#endif
