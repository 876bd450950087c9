// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// To be preloaded (LD_PRELOAD) into a program of Qt: it says which widgets are seen, and where, as
// JSON into the file that TETMARCH_WIDGETS names. A test can then send real events of mouse and
// keyboard there.
#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QGroupBox>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSaveFile>
#include <QTimer>

namespace
{
constexpr int Interval = 100; // milliseconds

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

void writeWidgets(const QString& path, int look)
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
    file.write(QJsonDocument({ { "look", look }, { "widgets", widgets } }).toJson());
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
  auto* timer = new QTimer(QCoreApplication::instance());
  int look = 0;
  QObject::connect(timer, &QTimer::timeout, [path, look]() mutable { writeWidgets(path, ++look); });
  timer->start(Interval);
}
} // namespace

Q_COREAPP_STARTUP_FUNCTION(watchWidgets)
