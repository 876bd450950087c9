// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PictureWidget.h"

#include "InteractorStyle.h"
#include "Model.h"

#include "vtkRenderWindowInteractor.h"

#include <QApplication>
#include <QMouseEvent>

namespace tetmarch
{

PictureWidget::PictureWidget(Model& model, QWidget* parent)
  : QVTKOpenGLNativeWidget(parent)
  , Shown(model)
{
  // One sample a pixel, as tetmarch-render has it, so that both draw the same picture.
  this->Own->SetMultiSamples(0);
  this->setRenderWindow(this->Own);
  this->setAcceptDrops(false); // the window takes files
  this->setFocusPolicy(Qt::StrongFocus);
  this->setMinimumSize(160, 120);
  vtkNew<InteractorStyle> style;
  style->SetModel(&model);
  this->interactor()->SetInteractorStyle(style);
  model.SetWindow(this->Own);
  model.GetEvents().SetPicture(this);
}

// A frame handles events, which is not allowed while a widget is painted. So a frame for the new
// size comes afterwards, and what was shown is stretched until then.
void PictureWidget::resizeGL(int width, int height)
{
  QVTKOpenGLNativeWidget::resizeGL(width, height);
  this->Shown.RequestRender();
}

void PictureWidget::paintGL()
{
  const bool later = this->Shown.HasData() && !this->Own->GetNeverRendered();
  this->interactor()->SetEnableRender(!later);
  QVTKOpenGLNativeWidget::paintGL();
  this->interactor()->SetEnableRender(true);
}

void PictureWidget::mousePressEvent(QMouseEvent* event)
{
  this->Pressed = event->pos();
  QVTKOpenGLNativeWidget::mousePressEvent(event);
}

void PictureWidget::mouseReleaseEvent(QMouseEvent* event)
{
  QVTKOpenGLNativeWidget::mouseReleaseEvent(event);
  const bool moved =
    (event->pos() - this->Pressed).manhattanLength() >= QApplication::startDragDistance() / 2;
  if (event->button() == Qt::LeftButton && !moved)
  {
    const double ratio = this->devicePixelRatioF();
    const int x = static_cast<int>((event->pos().x() + 0.5) * ratio);
    const int fromTop = static_cast<int>((event->pos().y() + 0.5) * ratio);
    Q_EMIT this->Clicked(x, this->Own->GetSize()[1] - 1 - fromTop);
  }
}

} // namespace tetmarch
