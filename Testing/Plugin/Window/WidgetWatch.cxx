// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// To be preloaded (LD_PRELOAD) into a program of Qt: it says which widgets are seen, and where, and
// whether the program is at rest, as JSON into the file that TETMARCH_WIDGETS names. A test can
// then send real events of mouse and keyboard there.
#include <QAbstractButton>
#include <QAbstractEventDispatcher>
#include <QApplication>
#include <QComboBox>
#include <QGroupBox>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPaintEvent>
#include <QSaveFile>
#include <QThread>
#include <QTimer>

#include <algorithm>
#include <mutex>
#include <unordered_set>
#include <utility>

extern Q_CORE_EXPORT quintptr qtHookData[];

namespace
{
constexpr int Interval = 100; // milliseconds
constexpr int Soon = 5000;    // milliseconds
// Pixels: a blinking caret repaints fewer.
constexpr int Caret = 1000;

QString pathOf(const QWidget* widget)
{
  const QString above = widget->parentWidget() ? pathOf(widget->parentWidget()) + "/" : QString();
  return above + widget->objectName();
}

QString textOf(const QWidget* widget)
{
  if (auto* button = qobject_cast<const QAbstractButton*>(widget))
  {
    return button->text();
  }
  if (auto* box = qobject_cast<const QComboBox*>(widget))
  {
    return box->currentText();
  }
  if (auto* label = qobject_cast<const QLabel*>(widget))
  {
    return label->text();
  }
  if (auto* line = qobject_cast<const QLineEdit*>(widget))
  {
    return line->text();
  }
  auto* group = qobject_cast<const QGroupBox*>(widget);
  return group ? group->title() : QString();
}

QJsonArray itemsOf(const QWidget* widget)
{
  QJsonArray items;
  if (auto* box = qobject_cast<const QComboBox*>(widget))
  {
    for (int i = 0; i < box->count(); ++i)
    {
      items.append(box->itemText(i));
    }
  }
  return items;
}

QJsonObject describe(const QWidget* widget)
{
  const QRect seen = widget->visibleRegion().boundingRect();
  const QPoint corner = widget->mapToGlobal(seen.topLeft());
  auto* button = qobject_cast<const QAbstractButton*>(widget);
  return { { "path", pathOf(widget) }, { "class", widget->metaObject()->className() },
    { "text", textOf(widget) }, { "items", itemsOf(widget) }, { "tooltip", widget->toolTip() },
    { "enabled", widget->isEnabled() }, { "checked", button && button->isChecked() },
    { "place", QJsonArray{ corner.x(), corner.y(), seen.width(), seen.height() } } };
}

// The entries of a menu are no widgets.
void addEntries(const QMenu* menu, QJsonArray& widgets)
{
  for (QAction* action : menu->actions())
  {
    const QRect rect = menu->actionGeometry(action);
    const QPoint corner = menu->mapToGlobal(rect.topLeft());
    widgets.append(QJsonObject{ { "path", pathOf(menu) + "/" + action->text().remove('&') },
      { "class", "QAction" }, { "text", action->text().remove('&') },
      { "enabled", action->isEnabled() }, { "checked", action->isChecked() },
      { "place", QJsonArray{ corner.x(), corner.y(), rect.width(), rect.height() } } });
  }
}

// All QObjects, which Qt's hooks for debuggers report: timers may have no parent.
class Objects
{
public:
  static void watch()
  {
    constexpr int addQObject = 3; // QHooks of Qt's private headers
    constexpr int removeQObject = 4;
    qtHookData[addQObject] = reinterpret_cast<quintptr>(&Objects::add);
    qtHookData[removeQObject] = reinterpret_cast<quintptr>(&Objects::remove);
  }

  // Whether a single-shot timer of this thread will fire soon.
  static bool putSomethingOff()
  {
    const std::lock_guard<std::mutex> lock(mutex());
    return std::any_of(all().begin(), all().end(), isPutOff);
  }

private:
  static bool isPutOff(QObject* object)
  {
    if (object->thread() != QThread::currentThread())
    {
      return false;
    }
    auto* timer = qobject_cast<QTimer*>(object);
    // QTimer::singleShot() makes objects of the other class.
    if (timer ? !timer->isSingleShot() : !object->inherits("QSingleShotTimer"))
    {
      return false;
    }
    const auto timers = QAbstractEventDispatcher::instance()->registeredTimers(object);
    return std::any_of(
      timers.begin(), timers.end(), [](const auto& info) { return info.interval < Soon; });
  }
  static void add(QObject* object)
  {
    const std::lock_guard<std::mutex> lock(mutex());
    all().insert(object);
  }
  static void remove(QObject* object)
  {
    const std::lock_guard<std::mutex> lock(mutex());
    all().erase(object);
  }
  // Never deleted: some objects end after the program's static ones.
  static std::unordered_set<QObject*>& all()
  {
    static auto* objects = new std::unordered_set<QObject*>;
    return *objects;
  }
  static std::mutex& mutex()
  {
    static auto* made = new std::mutex;
    return *made;
  }
};

// Notes that something was drawn.
class Painting : public QObject
{
public:
  bool takeSeen() { return std::exchange(this->Seen, false); }

  bool eventFilter(QObject* object, QEvent* event) override
  {
    if (event->type() == QEvent::Paint)
    {
      const QSize size = static_cast<QPaintEvent*>(event)->rect().size();
      this->Seen |= size.width() * size.height() > Caret;
    }
    // A window that the GL draws into.
    this->Seen |= event->type() == QEvent::UpdateRequest && object->inherits("QPaintDeviceWindow");
    return false;
  }

private:
  bool Seen = false;
};

void writeWidgets(const QString& path, int look, int quiet)
{
  QJsonArray widgets;
  for (const QWidget* widget : QApplication::allWidgets())
  {
    if (widget->isVisible() && !widget->visibleRegion().isEmpty())
    {
      widgets.append(describe(widget));
      if (auto* menu = qobject_cast<const QMenu*>(widget))
      {
        addEntries(menu, widgets);
      }
    }
  }
  QSaveFile file(path);
  if (file.open(QIODevice::WriteOnly))
  {
    file.write(
      QJsonDocument({ { "look", look }, { "quiet", quiet }, { "widgets", widgets } }).toJson());
    file.commit();
  }
}

// From the start of the program, again and again.
void watchWidgets()
{
  const QString path = qEnvironmentVariable("TETMARCH_WIDGETS");
  if (path.isEmpty() || !qobject_cast<QApplication*>(QCoreApplication::instance()))
  {
    return;
  }
  Objects::watch();
  auto* painting = new Painting;
  qApp->installEventFilter(painting);
  auto* timer = new QTimer(qApp);
  int look = 0;
  int quiet = 0; // looks since something was drawn or put off
  QObject::connect(timer, &QTimer::timeout,
    [=]() mutable
    {
      const bool seen = painting->takeSeen();
      quiet = seen || Objects::putSomethingOff() ? 0 : quiet + 1;
      writeWidgets(path, ++look, quiet);
    });
  timer->start(Interval);
}
} // namespace

Q_COREAPP_STARTUP_FUNCTION(watchWidgets)
