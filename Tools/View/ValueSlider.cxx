// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ValueSlider.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSlider>

#include <algorithm>
#include <cmath>

namespace
{
constexpr int Steps = 1000;
}

namespace tetmarch
{

ValueSlider::ValueSlider(double least, double most, Scale scale, QWidget* parent)
  : QWidget(parent)
  , Least(least)
  , Most(most)
  , HowScaled(scale)
  , Value(least)
  , Slider(new QSlider(Qt::Horizontal))
  , Text(new QLineEdit)
{
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(this->Slider, 1);
  layout->addWidget(this->Text);
  this->Slider->setRange(0, Steps);
  this->Slider->setPageStep(Steps / 20);
  this->Text->setFixedWidth(this->fontMetrics().horizontalAdvance(QStringLiteral("0.000000")) + 12);
  this->Text->setAlignment(Qt::AlignRight);
  this->ShowText();
  connect(this->Slider, &QSlider::sliderPressed, this, &ValueSlider::DragBegan);
  connect(this->Slider, &QSlider::sliderReleased, this, &ValueSlider::DragEnded);
  connect(this->Slider, &QSlider::valueChanged, this,
    [this](int position)
    {
      this->Value = this->At(position);
      this->ShowText();
      Q_EMIT this->Changed(this->Value);
    });
  connect(this->Text, &QLineEdit::editingFinished, this,
    [this]
    {
      bool isNumber = false;
      const double value = this->Text->text().toDouble(&isNumber);
      if (isNumber && this->Text->isModified())
      {
        this->SetValue(std::clamp(value, this->Least, this->Most));
        Q_EMIT this->Changed(this->Value);
      }
      this->ShowText();
    });
}

void ValueSlider::SetValue(double value)
{
  this->Value = value;
  const QSignalBlocker block(this->Slider);
  this->Slider->setValue(this->PositionOf(value));
  this->ShowText();
}

void ValueSlider::SetLimits(double least, double most)
{
  this->Least = least;
  this->Most = most;
  this->SetValue(this->Value);
}

void ValueSlider::ShowText()
{
  if (!this->Text->hasFocus() || !this->Text->isModified())
  {
    this->Text->setText(QString::number(this->Value, 'g', 3));
  }
  this->Text->setModified(false);
}

double ValueSlider::At(int position) const
{
  const double share = static_cast<double>(position) / Steps;
  return this->HowScaled == Linear ? this->Least + share * (this->Most - this->Least)
                                   : this->Least * std::pow(this->Most / this->Least, share);
}

int ValueSlider::PositionOf(double value) const
{
  const double inside = std::clamp(value, this->Least, this->Most);
  const double share = this->HowScaled == Linear
                         ? (inside - this->Least) / (this->Most - this->Least)
                         : std::log(inside / this->Least) / std::log(this->Most / this->Least);
  return static_cast<int>(std::lround(share * Steps));
}

} // namespace tetmarch
