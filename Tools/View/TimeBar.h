// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A slider over the time steps of a file, and a button that plays them.
 */
#ifndef tetmarch_TimeBar_h
#define tetmarch_TimeBar_h

#include <QToolBar>

class QAction;
class QLabel;
class QSlider;

namespace tetmarch
{
class Model;

class TimeBar : public QToolBar
{
  Q_OBJECT

public:
  explicit TimeBar(Model& model, QWidget* parent = nullptr);

  bool IsPlaying() const;

private:
  void ShowData();
  void Go(int step);
  void GoOn();
  void ShowStep(int step);

  Model& Shown;
  QAction* Play;
  QSlider* Slider;
  QLabel* Text;
};

} // namespace tetmarch

#endif
