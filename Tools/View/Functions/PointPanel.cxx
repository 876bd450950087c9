// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointPanel.h"

#include "NumberBox.h"

#include <QGridLayout>
#include <QLabel>
#include <QPixmap>
#include <QToolButton>

namespace tetmarch
{

PointPanel::PointPanel(QWidget* parent)
  : QWidget(parent)
{
  auto* const layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setHorizontalSpacing(6);
  layout->setVerticalSpacing(3);
  const char* const names[] = { "value", "opacity", "midpoint", "sharpness" };
  const QString texts[] = { tr("Value"), tr("Opacity"), tr("Midpoint"), tr("Sharpness") };
  const QString tips[] = { tr("Where the chosen point is"), tr("Opacity of the chosen point"),
    tr("Where, from this point (0) to the next (1), the curve is half way"),
    tr("0: a straight line to the next point; 1: a step at the midpoint") };
  for (int field = 0; field < 4; ++field)
  {
    this->Labels[field] = new QLabel(texts[field], this);
    this->Boxes[field] = new NumberBox(this);
    this->Boxes[field]->setObjectName(names[field]);
    this->Boxes[field]->setToolTip(tips[field]);
    this->Labels[field]->setBuddy(this->Boxes[field]);
    layout->addWidget(this->Labels[field], field / 2, field % 2 * 2);
    layout->addWidget(this->Boxes[field], field / 2, field % 2 * 2 + 1);
    QObject::connect(this->Boxes[field], QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
      [this, field](double number) { Q_EMIT this->NumberEdited(field, number); });
  }
  this->ColorButton = new QToolButton(this);
  this->ColorButton->setObjectName("color");
  this->ColorButton->setToolTip(tr("Choose the color of this point"));
  this->ColorButton->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  this->ColorButton->setIconSize(QSize(48, 14));
  layout->addWidget(this->ColorButton, 0, 3);
  layout->setColumnStretch(1, 1);
  layout->setColumnStretch(3, 1);
  QObject::connect(
    this->ColorButton, &QToolButton::clicked, this, [this] { Q_EMIT this->ColorAskedFor(); });
  this->ShowPoint(ControlPoint::Kind::None, {}, {});
}

void PointPanel::ShowPoint(
  ControlPoint::Kind kind, const std::array<double, 4>& numbers, const QColor& color)
{
  const bool isColor = kind == ControlPoint::Kind::Color;
  for (int field = 0; field < 4; ++field)
  {
    this->Boxes[field]->setEnabled(kind != ControlPoint::Kind::None);
    this->Boxes[field]->ShowNumber(numbers[field]);
  }
  this->Labels[Opacity]->setText(isColor ? tr("Color") : tr("Opacity"));
  this->Boxes[Opacity]->setVisible(!isColor);
  this->ColorButton->setVisible(isColor);
  if (isColor)
  {
    QPixmap swatch(this->ColorButton->iconSize());
    swatch.fill(color);
    this->ColorButton->setIcon(QIcon(swatch));
  }
}

void PointPanel::SetLimits(double low, double high) { this->Boxes[Value]->SetLimits(low, high); }

} // namespace tetmarch
