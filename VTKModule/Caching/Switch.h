// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A choice between two ways to draw the same picture.
#ifndef TetMarchCachingSwitch_h
#define TetMarchCachingSwitch_h

#include "Caching/Fingerprint.h"

namespace tetmarch
{

/**
 * A way that is worth its cost is taken, and kept as long as it is not clearly worse: each way is
 * another shader, which takes long to compile, and a user who drags a transfer function would
 * switch them to and fro.
 */
class Switch
{
public:
  /** keeps: it is not clearly worse. With another subject than last time that doesn't count. */
  void update(bool isWorth, bool keeps, const Fingerprint& subject)
  {
    this->Is = isWorth || (this->Is && keeps && subject == this->Subject);
    this->Subject = subject;
  }
  bool isOn() const { return this->Is; }

private:
  bool Is = false;
  Fingerprint Subject;
};

} // namespace tetmarch

#endif
