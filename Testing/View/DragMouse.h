// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef tetmarch_DragMouse_h
#define tetmarch_DragMouse_h

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
inline void DragMouse(QWidget* widget, const QPoint& from, const QPoint& to)
{
  SendMouse(widget, QEvent::MouseMove, from, Qt::NoButton, Qt::NoButton);
  SendMouse(widget, QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
  for (int i = 1; i <= 10; ++i)
  {
    SendMouse(widget, QEvent::MouseMove, from + (to - from) * i / 10, Qt::NoButton, Qt::LeftButton);
  }
  SendMouse(widget, QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton);
}

} // namespace tetmarch

#endif
