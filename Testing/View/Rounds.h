// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef tetmarch_Rounds_h
#define tetmarch_Rounds_h

#include <QTimer>

namespace tetmarch
{

/// Counts rounds of the event loop.
class Rounds
{
public:
  Rounds()
  {
    QObject::connect(&this->Timer, &QTimer::timeout, [this] { ++this->Count; });
    this->Timer.start(0);
  }

  int Count = 0;

private:
  QTimer Timer;
};

} // namespace tetmarch

#endif
