// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "NumberBox.h"

#include <QLocale>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>

namespace
{
/// All digits that a double can have, wherever its point is.
int CountDecimals(double magnitude)
{
  return magnitude > 0.0
           ? std::clamp(17 - static_cast<int>(std::floor(std::log10(magnitude))), 3, 300)
           : 17;
}
} // namespace

namespace tetmarch
{

NumberBox::NumberBox(QWidget* parent)
  : QDoubleSpinBox(parent)
{
  this->setLocale(QLocale::c());
  this->setKeyboardTracking(false); // 10 is not 1 first
  this->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  this->SetLimits(0.0, 1.0);
}

void NumberBox::SetLimits(double low, double high)
{
  const QSignalBlocker blocker(this);
  this->setDecimals(CountDecimals(high - low));
  const double ratio = std::max(std::abs(low), std::abs(high)) / (high - low);
  this->Digits = high > low ? std::clamp(6 + static_cast<int>(std::log10(ratio)), 6, 17) : 6;
  this->setRange(low, high);
  const double step = (high - low) / 100.0;
  this->setSingleStep(step > 0.0 && std::isfinite(step) ? step : 1.0);
}

void NumberBox::ShowNumber(double number)
{
  const QSignalBlocker blocker(this);
  this->setValue(number);
}

QString NumberBox::textFromValue(double value) const
{
  return QLocale::c().toString(value, 'g', this->Digits);
}

double NumberBox::valueFromText(const QString& text) const
{
  return QLocale::c().toDouble(text.trimmed());
}

QValidator::State NumberBox::validate(QString& text, int&) const
{
  bool isNumber = false;
  const double number = QLocale::c().toDouble(text.trimmed(), &isNumber);
  return isNumber && number >= this->minimum() && number <= this->maximum()
           ? QValidator::Acceptable
           : QValidator::Intermediate;
}

} // namespace tetmarch
