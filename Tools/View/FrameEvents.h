// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Qt's events while a frame is drawn. Timers, threads and panels go on. What the user does is kept
 * until the frame has ended, since it may change what is being drawn.
 */
#ifndef tetmarch_FrameEvents_h
#define tetmarch_FrameEvents_h

#include <QEvent>
#include <QObject>
#include <QPointer>

#include <memory>
#include <vector>

namespace tetmarch
{

class FrameEvents : public QObject
{
  Q_OBJECT

public:
  /// The widget that shows the frames: it is neither painted nor resized during one.
  void SetPicture(QObject* picture) { this->Picture = picture; }

  /// Frames may lie within each other.
  void Begin();
  /// Handles what has come so far. Returns whether the user has done something that waits.
  bool Handle();
  /// What was kept comes again, after all that is being handled.
  void End();

protected:
  bool eventFilter(QObject* receiver, QEvent* event) override;

private:
  struct Kept
  {
    QPointer<QObject> Receiver;
    std::unique_ptr<QEvent> Event;
  };

  void Keep(QObject* receiver, std::unique_ptr<QEvent> event);

  QPointer<QObject> Picture;
  std::vector<Kept> Waiting;
  bool IsAsked = false; // by the user, for something else than this frame
  int Depth = 0;
};

} // namespace tetmarch

#endif
