// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ColorMapBox.h"

#include "ColorMaps.h"
#include "FunctionSnapshot.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"

#include <QIcon>
#include <QImage>
#include <QPixmap>
#include <QStylePainter>

namespace
{
QIcon DrawMap(const std::string& name, const QSize& size)
{
  vtkNew<vtkColorTransferFunction> color;
  tetmarch::ApplyColorMap(name, 0.0, size.width() - 1.0, color);
  QImage image(size, QImage::Format_RGB32);
  for (int x = 0; x < size.width(); ++x)
  {
    double rgb[3];
    color->GetColor(x, rgb);
    const QRgb pixel = QColor::fromRgbF(rgb[0], rgb[1], rgb[2]).rgb();
    for (int y = 0; y < size.height(); ++y)
    {
      image.setPixel(x, y, pixel);
    }
  }
  return QIcon(QPixmap::fromImage(image));
}
} // namespace

namespace tetmarch
{

ColorMapBox::ColorMapBox(QWidget* parent)
  : QComboBox(parent)
{
  this->setIconSize(QSize(56, 12));
  this->setToolTip(tr("Colors by name, over the range of the present ones"));
  this->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  this->setMinimumContentsLength(8);
  this->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  for (const std::string& name : GetColorMapNames())
  {
    this->addItem(DrawMap(name, this->iconSize()), QString::fromStdString(name));
  }
  this->setCurrentIndex(-1);
  QObject::connect(this, QOverload<int>::of(&QComboBox::activated), this,
    [this](int index) { Q_EMIT this->MapChosen(this->itemText(index)); });
}

void ColorMapBox::ShowMapOf(vtkColorTransferFunction* color)
{
  int found = -1;
  vtkNew<vtkPiecewiseFunction> none;
  const FunctionSnapshot shown = TakeSnapshot(color, none);
  for (int i = 0; i < this->count() && color->GetSize() > 0 && found < 0; ++i)
  {
    vtkNew<vtkColorTransferFunction> map;
    map->SetScale(color->GetScale());
    ApplyColorMap(this->itemText(i).toStdString(), color->GetRange()[0], color->GetRange()[1], map);
    const FunctionSnapshot state = TakeSnapshot(map, none);
    found = state.Colors == shown.Colors && state.ColorSpace == shown.ColorSpace ? i : -1;
  }
  this->setCurrentIndex(found);
}

void ColorMapBox::paintEvent(QPaintEvent*)
{
  // Qt 5 doesn't draw the placeholder of a box that can't be edited.
  QStyleOptionComboBox option;
  this->initStyleOption(&option);
  if (this->currentIndex() < 0)
  {
    option.currentText = tr("Own colors");
  }
  QStylePainter painter(this);
  painter.drawComplexControl(QStyle::CC_ComboBox, option);
  painter.drawControl(QStyle::CE_ComboBoxLabel, option);
}

} // namespace tetmarch
