// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Pictures of tetmarch-view for the pages: tetmarch-view-screenshots DATA_FOLDER PICTURE_FOLDER
#include "Effect.h"
#include "EffectTimer.h"
#include "EffectsPanel.h"
#include "MainWindow.h"
#include "Messages.h"
#include "WriteKinds.h"

#include "vtkTetMarchSettings.h"

#include <QApplication>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QPainter>
#include <QPixmap>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <QVTKOpenGLNativeWidget.h>

namespace
{
using namespace tetmarch;

void WaitFor(int milliseconds)
{
  QElapsedTimer timer;
  timer.start();
  while (timer.elapsed() < milliseconds)
  {
    QApplication::processEvents(QEventLoop::AllEvents, 50);
  }
}

void Open(MainWindow& window, const QString& path)
{
  window.Open(path);
  while (window.GetModel().GetLoader().IsBusy())
  {
    WaitFor(50);
  }
  WaitFor(1500);
}

// What the panels have measured of a few tolerances.
void TryTolerances(MainWindow& window)
{
  for (const double tolerance : { 0.03, 0.01, 0.004, 0.001, 0.0003 })
  {
    window.GetModel().Edit(
      [tolerance](ViewState& state) { state.Settings.ErrorTolerance = tolerance; });
    WaitFor(1500);
  }
}

// What each effect adds to a frame.
void MeasureEffects(MainWindow& window)
{
  EffectTimer* timer = window.findChild<EffectsPanel*>()->GetTimer();
  for (std::size_t i = 0; i < GetEffects().size(); ++i)
  {
    timer->Measure(static_cast<int>(i));
  }
  while (timer->IsBusy())
  {
    WaitFor(50);
  }
}

bool Save(MainWindow& window, const QString& path)
{
  WaitFor(1000);
  return window.grab().save(path);
}

// Four kinds of data, each as it is first seen, in one picture.
bool SaveKinds(const QString& path)
{
  const QTemporaryDir folder;
  MainWindow window;
  window.resize(1000, 700);
  window.show();
  QPixmap all(2 * window.size());
  QPainter painter(&all);
  int number = 0;
  for (const auto& write : { WriteMixedCells, WriteCellScalars, WriteBlocks, WriteTimeSeries })
  {
    Open(window, write(folder.path()));
    WaitFor(1000);
    painter.drawPixmap(number % 2 * window.width(), number / 2 * window.height(), window.grab());
    ++number;
  }
  painter.end();
  return all.save(path);
}
} // namespace

int main(int argc, char* argv[])
{
  if (argc != 3)
  {
    std::fputs("usage: tetmarch-view-screenshots DATA_FOLDER PICTURE_FOLDER\n", stderr);
    return 2;
  }
  SetProgramName("tetmarch-view-screenshots");
  Messages::Install();
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QApplication application(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("TetMarch"));
  QApplication::setApplicationName(QStringLiteral("tetmarch-view-screenshots"));
  const QString data = QString::fromLocal8Bit(argv[1]) + QLatin1Char('/');
  const QString pictures = QString::fromLocal8Bit(argv[2]) + QLatin1Char('/');

  MainWindow window;
  window.resize(1200, 800);
  window.show();
  Open(window, data + QStringLiteral("golfball_small.vtu"));
  TryTolerances(window);
  bool saved = Save(window, pictures + QStringLiteral("window_accuracy.png"));

  Open(window, data + QStringLiteral("bonsai_small.vti"));
  window.GetModel().Edit(
    [](ViewState& state)
    {
      state.Effects.Shading = true;
      state.Settings.ShadowMethod = vtkTetMarchSettings::SHADOWS_AT_VERTICES;
    });
  window.GetModel().LookAlong(2);
  window.findChild<QDockWidget*>(QStringLiteral("effects"))->raise();
  WaitFor(1000);
  MeasureEffects(window);
  saved = Save(window, pictures + QStringLiteral("window_effects.png")) && saved;
  window.hide();
  saved = SaveKinds(pictures + QStringLiteral("window_kinds.png")) && saved;
  return saved && Messages::GetNumberOfErrors() == 0 ? 0 : 1;
}
