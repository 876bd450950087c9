// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A slider for a number, with the number beside it; linear, or logarithmic for what spans decades.
 */
#ifndef tetmarch_ValueSlider_h
#define tetmarch_ValueSlider_h

#include <QWidget>

class QLineEdit;
class QSlider;

namespace tetmarch
{

class ValueSlider : public QWidget
{
  Q_OBJECT

public:
  enum Scale
  {
    Linear,
    Logarithmic
  };
  ValueSlider(double least, double most, Scale scale, QWidget* parent = nullptr);

  double GetValue() const { return this->Value; }
  /// Emits no signal.
  void SetValue(double value);
  void SetLimits(double least, double most);

Q_SIGNALS:
  /// By the user, also while dragging.
  void Changed(double value);
  void DragBegan();
  void DragEnded();

private:
  void ShowText();
  double At(int position) const;
  int PositionOf(double value) const;

  double Least;
  double Most;
  Scale HowScaled;
  double Value;
  QSlider* Slider;
  QLineEdit* Text;
};

} // namespace tetmarch

#endif
