// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameEvents.h"

#include <QCoreApplication>
#include <QDropEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QResizeEvent>
#include <QShortcutEvent>
#include <QWheelEvent>
#include <QWidget>

namespace
{
constexpr int MostMilliseconds = 100; // for one round of events

template <typename Event>
std::unique_ptr<QEvent> CopyOf(const QEvent* event)
{
  return std::make_unique<Event>(*static_cast<const Event*>(event));
}

/// Null: the event is none of the user's.
std::unique_ptr<QEvent> CopyInput(const QEvent* event)
{
  switch (event->type())
  {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
      return CopyOf<QMouseEvent>(event);
    case QEvent::Wheel:
      return CopyOf<QWheelEvent>(event);
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
      return CopyOf<QKeyEvent>(event);
    case QEvent::Shortcut:
      return CopyOf<QShortcutEvent>(event);
    case QEvent::ContextMenu:
      return CopyOf<QContextMenuEvent>(event);
    case QEvent::Close:
      return std::make_unique<QCloseEvent>();
    default:
      return nullptr;
  }
}

/// Moves and releases say nothing without the press that came before.
bool AsksForMore(QEvent::Type type)
{
  return type != QEvent::MouseMove && type != QEvent::MouseButtonRelease &&
         type != QEvent::KeyRelease;
}

bool IsDrag(QEvent::Type type)
{
  return type == QEvent::DragEnter || type == QEvent::DragMove || type == QEvent::Drop;
}
} // namespace

namespace tetmarch
{

void FrameEvents::Begin()
{
  if (this->Depth++ == 0)
  {
    this->IsAsked = false;
    QCoreApplication::instance()->installEventFilter(this);
  }
}

bool FrameEvents::Handle()
{
  QCoreApplication::processEvents(QEventLoop::AllEvents, MostMilliseconds);
  return this->IsAsked;
}

void FrameEvents::End()
{
  if (--this->Depth > 0)
  {
    return;
  }
  QCoreApplication::instance()->removeEventFilter(this);
  for (Kept& kept : this->Waiting)
  {
    auto* widget = qobject_cast<QWidget*>(kept.Receiver.data());
    if (widget && kept.Event->type() == QEvent::Close)
    {
      QMetaObject::invokeMethod(widget, "close", Qt::QueuedConnection);
    }
    else if (kept.Receiver)
    {
      QCoreApplication::postEvent(kept.Receiver, kept.Event.release());
    }
  }
  this->Waiting.clear();
}

void FrameEvents::Keep(QObject* receiver, std::unique_ptr<QEvent> event)
{
  const bool moves = event->type() == QEvent::MouseMove && !this->Waiting.empty() &&
                     this->Waiting.back().Receiver == receiver &&
                     this->Waiting.back().Event->type() == QEvent::MouseMove;
  if (moves)
  {
    this->Waiting.pop_back(); // only the last place counts
  }
  this->Waiting.push_back({ receiver, std::move(event) });
}

bool FrameEvents::eventFilter(QObject* receiver, QEvent* event)
{
  const QEvent::Type type = event->type();
  if (receiver == this->Picture && type == QEvent::Paint)
  {
    return true; // it shows what it has shown
  }
  if (receiver == this->Picture && type == QEvent::Resize)
  {
    this->IsAsked = true;
    this->Keep(receiver, CopyOf<QResizeEvent>(event));
    return true;
  }
  if (IsDrag(
        type)) // these can't wait: the source of the drag is told that nothing can be dropped now
  {
    this->IsAsked = true;
    event->ignore();
    return true;
  }
  std::unique_ptr<QEvent> copy = CopyInput(event);
  if (!copy)
  {
    return false;
  }
  this->IsAsked = this->IsAsked || AsksForMore(type);
  this->Keep(receiver, std::move(copy));
  event->setAccepted(type != QEvent::Close);
  return true;
}

} // namespace tetmarch
