// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef tetmarch_DragInChart_h
#define tetmarch_DragInChart_h

#include <QCoreApplication>
#include <QMouseEvent>
#include <QWidget>

namespace tetmarch
{

inline void SendMouse(QWidget* widget, QEvent::Type type, const QPoint& place,
  Qt::MouseButton button, Qt::MouseButtons buttons)
{
  QMouseEvent event(type, place, widget->mapToGlobal(place), button, buttons, Qt::NoModifier);
  QCoreApplication::sendEvent(widget, &event);
}

/// In ten moves, as a hand does it.
inline void DragInChart(QWidget* chart, const QPoint& from, const QPoint& to)
{
  SendMouse(chart, QEvent::MouseMove, from, Qt::NoButton, Qt::NoButton);
  SendMouse(chart, QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
  for (int i = 1; i <= 10; ++i)
  {
    SendMouse(chart, QEvent::MouseMove, from + (to - from) * i / 10, Qt::NoButton, Qt::LeftButton);
  }
  SendMouse(chart, QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton);
}

} // namespace tetmarch

#endif
