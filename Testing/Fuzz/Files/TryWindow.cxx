// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Opens files in the window of tetmarch-view, one after the other, and draws them: their names come
// from standard input, and a line for each goes to standard output:
//   OUTCOME<tab>MESSAGE
// where OUTCOME is "read", "refused" with the message that the window shows, or "silent": neither
// data nor a message. A crash ends the program, and so does a file that takes longer than
// MostSeconds: SIGXCPU or SIGALRM.
#include "MainWindow.h"
#include "Messages.h"
#include "ReaderCrash.h"
#include "SessionKeeper.h"

#include <QApplication>
#include <QMessageBox>
#include <QSettings>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <QTimer>
#include <QVTKOpenGLNativeWidget.h>

#include <cstdio>
#include <fcntl.h>
#include <fstream>
#include <iostream>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

namespace
{
using namespace tetmarch;

constexpr rlim_t MostSeconds = 20; // of the processor
constexpr rlim_t Gigabyte = 1ull << 30;

void limitTime()
{
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  rlimit limits{};
  getrlimit(RLIMIT_CPU, &limits);
  limits.rlim_cur =
    static_cast<rlim_t>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) + MostSeconds + 1;
  setrlimit(RLIMIT_CPU, &limits);
  alarm(20 * MostSeconds); // if it waits for what never comes
}

// What a file may take beyond what the window has taken.
void limitMemory()
{
  rlim_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const rlim_t most = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + 4 * Gigabyte;
  const rlimit limits{ most, most };
  setrlimit(RLIMIT_AS, &limits);
}

void waitForRest(Model& model)
{
  QTimer wakes; // for what other threads do
  wakes.start(5);
  QCoreApplication::processEvents();
  while (model.GetLoader().IsBusy() || model.HasFramesToDraw())
  {
    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }
}

// The text of the box that is open; it is closed.
std::string takeMessage(MainWindow& window)
{
  std::string text;
  for (QMessageBox* box : window.findChildren<QMessageBox*>())
  {
    text += box->text().toStdString();
    delete box;
  }
  return text.substr(0, text.find('\n'));
}

void openAll(MainWindow& window, std::FILE* results)
{
  int shown = 0;
  QObject::connect(&window.GetModel(), &Model::DataChanged, [&shown] { ++shown; });
  for (std::string path; std::getline(std::cin, path);)
  {
    limitTime();
    const int before = shown;
    window.Open(QString::fromStdString(path));
    waitForRest(window.GetModel());
    const std::string message = takeMessage(window);
    const char* outcome = !message.empty() ? "refused" : shown > before ? "read" : "silent";
    std::fprintf(results, "%s\t%s\n", outcome, message.c_str());
    std::fflush(results);
  }
}
} // namespace

int main(int argc, char* argv[])
{
  SetProgramName("tetmarch-view");
  Messages::Install();
  // Some libraries below VTK's readers print.
  std::FILE* results = fdopen(dup(STDOUT_FILENO), "w");
  dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
  const rlimit none{ 0, 0 };
  setrlimit(RLIMIT_CORE, &none);
  TellCrashesOfReaders();
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QApplication application(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("TetMarch"));
  QApplication::setApplicationName(QStringLiteral("tetmarch-view-fuzz"));
  const QTemporaryDir folder; // not the user's
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder.path());
  MainWindow window;
  window.show();
  const SessionKeeper keeper(window, folder.filePath(QStringLiteral("sessions")));
  waitForRest(window.GetModel());
  limitMemory();
  openAll(window, results);
  return 0;
}
