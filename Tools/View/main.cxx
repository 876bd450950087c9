// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"
#include "Failure.h"
#include "MainWindow.h"
#include "Messages.h"
#include "ReaderCrash.h"
#include "SessionKeeper.h"
#include "StandardOutput.h"

#include "vtkVersion.h"

#include <QApplication>
#include <QSurfaceFormat>
#include <QVTKOpenGLNativeWidget.h>

namespace
{
using namespace tetmarch;

int Show(const std::string& file, int argc, char* argv[])
{
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QApplication application(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("TetMarch"));
  QApplication::setApplicationName(QStringLiteral("tetmarch-view"));
  MainWindow window;
  window.show();
  const SessionKeeper keeper(window, SessionKeeper::GetFolder());
  if (!file.empty())
  {
    window.Open(QString::fromStdString(file));
  }
  return QApplication::exec();
}
} // namespace

int main(int argc, char* argv[])
{
  SetProgramName("tetmarch-view");
  Messages::Install();
  TellCrashesOfReaders();
  try
  {
    const Arguments arguments = ParseArguments({ argv + 1, argv + argc });
    if (arguments.Help)
    {
      PrintText(GetViewHelp());
      return 0;
    }
    if (arguments.Version)
    {
      PrintText(std::string("tetmarch-view ") + TETMARCH_VERSION + " (VTK " +
                vtkVersion::GetVTKVersion() + ", Qt " + qVersion() + ")\n");
      return 0;
    }
    const std::string problem = FindDisplayProblem();
    if (!problem.empty())
    {
      PrintMessage("error", problem);
      return 1;
    }
    return Show(arguments.File, argc, argv);
  }
  catch (const UsageError& error)
  {
    PrintMessage("error", std::string(error.what()) + " (--help shows the usage)");
    return 2;
  }
  catch (const Failure& failure)
  {
    PrintMessage("error", failure.what());
    return 1;
  }
}
