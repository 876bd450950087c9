// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include <QApplication>
#include <QSurfaceFormat>
#include <QVTKOpenGLNativeWidget.h>

int RunMouseTest(int argc, char** argv);
int RunShownFunctionsTest(int argc, char** argv);
int RunWholeFunctionsTest(int argc, char** argv);

int main(int argc, char** argv)
{
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QApplication application(argc, argv);
  int failures = RunMouseTest(argc, argv);
  failures += RunShownFunctionsTest(argc, argv);
  failures += RunWholeFunctionsTest(argc, argv);
  return failures > 0;
}
