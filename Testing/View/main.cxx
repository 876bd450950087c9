// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// All tests of tetmarch-view, in one program with one application.
#include "AliveTest.h"
#include "CrashTest.h"
#include "FunctionsTest.h"
#include "OpenTest.h"
#include "PlayTest.h"
#include "SessionTest.h"

#include "Messages.h"

#include <QApplication>
#include <QSurfaceFormat>
#include <QVTKOpenGLNativeWidget.h>
#include <QtTest>

int main(int argc, char* argv[])
{
  tetmarch::SetProgramName("tetmarch-view");
  tetmarch::Messages::Install();
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QApplication application(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("TetMarch"));
  QApplication::setApplicationName(QStringLiteral("tetmarch-view-test"));
  if (argc == 3 && argv[1] == std::string("--until-killed"))
  {
    return tetmarch::CrashTest::ReadUntilKilled(QString::fromLocal8Bit(argv[2]));
  }
  const QString suite = argc > 1 ? QString::fromLocal8Bit(argv[1]) : QString();
  QStringList arguments = QApplication::arguments();
  if (!suite.isEmpty())
  {
    arguments.removeAt(1);
  }
  tetmarch::OpenTest open;
  tetmarch::AliveTest alive;
  tetmarch::CrashTest crash;
  tetmarch::FunctionsTest functions;
  tetmarch::PlayTest play;
  tetmarch::SessionTest session;
  int failures = 0;
  bool found = false;
  for (QObject* test : { static_cast<QObject*>(&open), static_cast<QObject*>(&functions),
         static_cast<QObject*>(&play), static_cast<QObject*>(&session),
         static_cast<QObject*>(&alive), static_cast<QObject*>(&crash) })
  {
    const QString name = QString::fromLatin1(test->metaObject()->className()).section("::", -1);
    if (name == suite)
    {
      found = true;
      failures += QTest::qExec(test, arguments);
    }
  }
  if (!found)
  {
    std::fputs("usage: TetMarchViewerTest "
               "AliveTest|CrashTest|OpenTest|FunctionsTest|PlayTest|SessionTest [option "
               "of Qt Test]...\n",
      stderr);
    return 2;
  }
  return failures;
}
