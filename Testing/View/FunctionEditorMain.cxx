// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include <QApplication>
#include <QSurfaceFormat>
#include <QVTKOpenGLNativeWidget.h>

int RunMouseTest(int argc, char** argv);
int RunWholeFunctionsTest(int argc, char** argv);

int main(int argc, char** argv)
{
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QApplication application(argc, argv);
  const int failures = RunMouseTest(argc, argv);
  return failures + RunWholeFunctionsTest(argc, argv);
}
