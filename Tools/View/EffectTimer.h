// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What one effect adds to a frame of the scene as it is. A turn is four frames: without it, twice,
 * then with it, twice; the second of both counts. Documentation/Effects.md says why.
 */
#ifndef tetmarch_EffectTimer_h
#define tetmarch_EffectTimer_h

#include "ViewState.h"

#include <QObject>
#include <QTimer>

#include <deque>
#include <vector>

namespace tetmarch
{
class Model;

class EffectTimer : public QObject
{
  Q_OBJECT

public:
  explicit EffectTimer(Model& model, QObject* parent = nullptr);

  /// Of GetEffects(). Those that are being measured go on; one that waits already isn't added.
  void Measure(int effect);
  /// The picture is that of the state again.
  void Stop();
  bool IsBusy() const { return !this->Waiting.empty(); }

Q_SIGNALS:
  /// Medians: seconds with the effect beyond those without, and what the first frame took beyond.
  void Measured(int effect, double added, double once);
  void Done();

private:
  void TakeFrame();
  void Finish();
  void ShowState();

  Model& Timed;
  QTimer Next;
  std::deque<int> Waiting;
  std::vector<double> Turn; // seconds of its frames
  std::vector<double> Added;
  std::vector<double> Once;
};

} // namespace tetmarch

#endif
