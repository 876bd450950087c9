// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef tetmarch_PointPanel_h
#define tetmarch_PointPanel_h

#include "FunctionChart.h"

#include <QColor>
#include <QWidget>

#include <array>

class QLabel;
class QToolButton;

namespace tetmarch
{
class NumberBox;

/// The numbers of the chosen point.
class PointPanel : public QWidget
{
  Q_OBJECT

public:
  enum Field
  {
    Value,
    Opacity,
    Midpoint,
    Sharpness
  };

  explicit PointPanel(QWidget* parent = nullptr);

  /// Of a colour point, the opacity in numbers is not shown, but a button with its colour.
  void ShowPoint(
    ControlPoint::Kind kind, const std::array<double, 4>& numbers, const QColor& color);

  /// The values between which the point can be moved.
  void SetLimits(double low, double high);

Q_SIGNALS:
  /// One of Field has another number.
  void NumberEdited(int field, double number);
  void ColorAskedFor();

private:
  std::array<QLabel*, 4> Labels = {};
  std::array<NumberBox*, 4> Boxes = {};
  QToolButton* ColorButton = nullptr;
};

} // namespace tetmarch

#endif
