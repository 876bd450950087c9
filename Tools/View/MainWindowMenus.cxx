// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"
#include "MainWindow.h"

#include "vtkVersion.h"

#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QStatusBar>

namespace
{
constexpr int MessageMilliseconds = 5000;
}

namespace tetmarch
{

void MainWindow::MakeFileMenu()
{
  QMenu* menu = this->menuBar()->addMenu(tr("&File"));
  const auto add = [&](const QString& text, const QKeySequence& keys, const auto& act)
  {
    QAction* action = menu->addAction(text);
    action->setShortcut(keys);
    connect(action, &QAction::triggered, this, act);
    return action;
  };
  const auto needsData = [this](QAction* action)
  {
    action->setEnabled(false);
    connect(&this->Shown, &Model::DataChanged, action, [action] { action->setEnabled(true); });
  };
  const auto copy = [this](const QString& text, const QString& what)
  {
    QApplication::clipboard()->setText(text);
    this->statusBar()->showMessage(tr("Copied %1").arg(what), MessageMilliseconds);
  };
  add(tr("&Open…"), QKeySequence::Open, [this] { this->AskForFile(); });
  this->Recent = menu->addMenu(tr("Open &recent"));
  connect(this->Recent, &QMenu::aboutToShow, this, &MainWindow::ShowRecent);
  needsData(add(tr("Open opaque &surface…"), {}, [this] { this->AskForSurface(); }));
  menu->addSeparator();
  needsData(add(tr("Save s&ession…"), QKeySequence::Save, [this] { this->AskForSession(); }));
  needsData(
    add(tr("Save &picture…"), QKeySequence(tr("Ctrl+P")), [this] { this->AskForScreenshot(); }));
  needsData(add(
    tr("Save as &web page…"), QKeySequence(tr("Ctrl+Shift+S")), [this] { this->AskForPage(); }));
  menu->addSeparator();
  needsData(add(tr("Copy as P&ython"), QKeySequence(tr("Ctrl+Shift+P")),
    [this, copy] { copy(this->GetPythonScript(), tr("a script of Python")); }));
  needsData(add(tr("Copy as command &line"), QKeySequence(tr("Ctrl+Shift+C")),
    [this, copy] { copy(this->GetCommandLine(), tr("a command of tetmarch-render")); }));
  needsData(add(tr("Copy what was &clicked"), QKeySequence::Copy,
    [this, copy] { copy(this->PickText->text(), tr("the cell that was clicked")); }));
  menu->addSeparator();
  add(tr("&Quit"), QKeySequence::Quit, [this] { this->close(); });
}

void MainWindow::MakeViewMenu()
{
  QMenu* menu = this->menuBar()->addMenu(tr("&View"));
  menu->addAction(tr("&All of the data (r)"), &this->Shown, &Model::ResetCamera);
  for (int axis = 0; axis < 3; ++axis)
  {
    const QChar name('x' + axis);
    menu->addAction(
      tr("Along &%1 (%1)").arg(name), this, [this, axis] { this->Shown.LookAlong(axis); });
  }
  menu->addAction(tr("&Parallel or perspective (5)"), &this->Shown, &Model::SwitchProjection);
  menu->addSeparator();
  QMenu* background = menu->addMenu(tr("&Background"));
  const std::pair<QString, Vector3> colors[] = { { tr("Dark"), ViewState().Background },
    { tr("Black"), { { 0.0, 0.0, 0.0 } } }, { tr("Grey"), { { 0.5, 0.5, 0.5 } } },
    { tr("White"), { { 1.0, 1.0, 1.0 } } } };
  for (const auto& [name, color] : colors)
  {
    background->addAction(name, this,
      [this, rgb = color] { this->Shown.Edit([&](ViewState& s) { s.Background = rgb; }); });
  }
  menu->addMenu(this->Panels);
}

void MainWindow::MakeHelpMenu()
{
  QMenu* menu = this->menuBar()->addMenu(tr("&Help"));
  const auto show = [this](const QString& title, const QString& text)
  {
    auto* box = new QMessageBox(QMessageBox::NoIcon, title, text, QMessageBox::Ok, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
  };
  menu->addAction(tr("&Mouse and keys"), this,
    [show]
    {
      show(tr("Mouse and keys"), tr("<table cellspacing=6>"
                                    "<tr><td>Left</td><td>turn</td></tr>"
                                    "<tr><td>Middle, or Shift and left</td><td>move</td></tr>"
                                    "<tr><td>Right, or wheel</td><td>nearer or further</td></tr>"
                                    "<tr><td>Click</td><td>cell, position and value there</td></tr>"
                                    "<tr><td>x y z</td><td>look along that axis</td></tr>"
                                    "<tr><td>5</td><td>parallel or perspective</td></tr>"
                                    "<tr><td>r</td><td>all of the data in view</td></tr></table>"));
    });
  menu->addAction(tr("&About"), this,
    [show]
    {
      show(tr("About"),
        tr("<b>TetMarch %1</b><br>Volumes by marching each ray from cell to cell."
           "<br>VTK %2, Qt %3")
          .arg(QStringLiteral(TETMARCH_VERSION), QString::fromUtf8(vtkVersion::GetVTKVersion()),
            QString::fromUtf8(qVersion())));
    });
}

} // namespace tetmarch
