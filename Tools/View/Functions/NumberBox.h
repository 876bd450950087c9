// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef tetmarch_NumberBox_h
#define tetmarch_NumberBox_h

#include <QDoubleSpinBox>

namespace tetmarch
{

/// A spin box for numbers of any magnitude: as many digits are shown as tell a
/// millionth of the limits' width, and 3e-7 can be typed.
class NumberBox : public QDoubleSpinBox
{
  Q_OBJECT

public:
  explicit NumberBox(QWidget* parent = nullptr);

  /// The numbers that can be entered; a step is a hundredth of their width.
  void SetLimits(double low, double high);

  /// Shows a number and emits nothing.
  void ShowNumber(double number);

  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;
  QValidator::State validate(QString& text, int& position) const override;
  QSize minimumSizeHint() const override
  {
    return { 56, QDoubleSpinBox::minimumSizeHint().height() };
  }

private:
  int Digits = 6;
};

} // namespace tetmarch

#endif
