// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// All tests of tetmarch-view, in one program with one application.
#include "Messages.h"
#include "Programs.h"

#include <QApplication>
#include <QSurfaceFormat>
#include <QVTKOpenGLNativeWidget.h>

#include <cstdio>

int main(int argc, char* argv[])
{
  tetmarch::SetProgramName("tetmarch-view");
  tetmarch::Messages::Install();
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QApplication application(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("TetMarch"));
  QApplication::setApplicationName(QStringLiteral("tetmarch-view-test"));
  QStringList arguments = QApplication::arguments();
  const QString name = arguments.size() > 1 ? arguments.takeAt(1) : QString();
  const auto& programs = tetmarch::GetPrograms();
  const auto program = programs.find(name);
  if (program != programs.end())
  {
    return program->second(arguments);
  }
  std::fputs("usage: TetMarchViewerTest SUITE [option of Qt Test]...\nThe suites are:\n", stderr);
  for (const auto& known : programs)
  {
    std::fprintf(stderr, "  %s\n", qPrintable(known.first));
  }
  return 2;
}
