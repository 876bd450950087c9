// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A choice between two methods to draw the same picture, with hysteresis.
#ifndef TetMarchCachingSwitch_h
#define TetMarchCachingSwitch_h

#include "Caching/Fingerprint.h"

namespace tetmarch
{

/**
 * A method that is worth its cost is chosen, and kept until it is clearly worse: each method is
 * another shader, which takes long to compile, and dragging a transfer function would otherwise
 * alternate between them.
 */
class Switch
{
public:
  /** keeps: it is not clearly worse. Ignored if the subject has changed. */
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
