// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What Qt tells the chart.
#include "FunctionChart.h"

#include <QEvent>
#include <QKeyEvent>

namespace tetmarch
{

bool FunctionChart::event(QEvent* event)
{
  switch (event->type())
  {
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
    {
      // VTK would take letters for commands of its own: q would end the program.
      const int key = static_cast<QKeyEvent*>(event)->key();
      const bool deletes = key == Qt::Key_Delete || key == Qt::Key_Backspace;
      if (deletes && event->type() == QEvent::KeyPress)
      {
        this->DeleteChosenPoint();
      }
      event->setAccepted(deletes);
      return deletes;
    }
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
      Q_EMIT this->MousePressed();
      QVTKOpenGLNativeWidget::event(event);
      event->accept();
      return true;
    case QEvent::MouseButtonRelease:
      QVTKOpenGLNativeWidget::event(event);
      Q_EMIT this->MouseReleased();
      event->accept();
      return true;
    default:
      return QVTKOpenGLNativeWidget::event(event);
  }
}

void FunctionChart::resizeEvent(QResizeEvent* event)
{
  QVTKOpenGLNativeWidget::resizeEvent(event);
  this->PlaceCharts();
}

void FunctionChart::changeEvent(QEvent* event)
{
  QVTKOpenGLNativeWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange)
  {
    this->TakePalette();
  }
}

} // namespace tetmarch
