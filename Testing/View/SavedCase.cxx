// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SavedCase.h"

#include "RenderCommand.h"

#include "vtkTetMarchSettings.h"

#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QtTest>

namespace
{
constexpr int Patience = 1000000; // milliseconds, for a program
}

namespace tetmarch
{

void AddLight(ViewState& s)
{
  s.Effects.Shading = true;
  s.Settings.ShadowMethod = vtkTetMarchSettings::SHADOWS_AT_VERTICES;
  s.Settings.AmbientOcclusion = true;
  s.Effects.Scattering = true;
  s.Effects.LightFrom = { { -1.0, 0.3, 0.8 } };
}

void AddCuts(ViewState& s)
{
  s.Cuts.Clip = true;
  s.Cuts.Normal = { { -0.6, 0.0, 0.8 } };
  s.Cuts.Crop = true;
  s.Cuts.Box[1] = 0.3 * s.Cuts.Box[0] + 0.7 * s.Cuts.Box[1];
  s.Background = { { 0.9, 0.8, 0.7 } };
}

void ShowCells(ViewState& s)
{
  s.Settings.ViewMode = vtkTetMarchSettings::VIEW_CELLS;
  s.Camera.Parallel = true;
  s.Settings.AccuracyLevel = vtkTetMarchSettings::ACCURATE;
}

void SavedCase::CheckPicture()
{
  this->TakePicture();
  // Beside each other.
  QProcess command;
  QProcess script;
  this->StartCommand(command);
  this->StartScript(script);
  this->CheckSession();
  this->CheckProgram(command, "command.png");
#ifdef TETMARCH_PYTHON
  this->CheckProgram(script, "script.png");
#endif
}

void SavedCase::TakePicture()
{
  const QString path = this->Folder.filePath(QStringLiteral("shown.png"));
  QVERIFY(this->Window->SaveScreenshot(path));
  this->Shown = ReadPng(path);
  QVERIFY(CountDrawn(this->Shown) > 1000);
}

void SavedCase::StartCommand(QProcess& process)
{
  const QString drawn = this->Folder.filePath(QStringLiteral("command.png"));
  const std::string command = WriteCommand(this->GetModel().GetState(), drawn.toStdString());
  QVERIFY(command.find("#") == std::string::npos); // nothing is left out
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert(QStringLiteral("PATH"), QStringLiteral(TETMARCH_BIN ":") + qgetenv("PATH"));
  environment.insert(QStringLiteral("TETMARCH_GL"), QStringLiteral("egl"));
  environment.remove(QStringLiteral("DISPLAY"));
  process.setProcessEnvironment(environment);
  process.start(
    QStringLiteral("/bin/sh"), { QStringLiteral("-c"), QString::fromStdString(command) });
  QVERIFY(process.waitForStarted(Patience));
}

void SavedCase::StartScript(QProcess& process)
{
#ifdef TETMARCH_PYTHON
  QFile script(this->Folder.filePath(QStringLiteral("script.py")));
  QVERIFY(script.open(QIODevice::WriteOnly));
  script.write(this->Window->GetPythonScript().toUtf8());
  script.close();
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert(QStringLiteral("PYTHONPATH"), QStringLiteral(TETMARCH_PYTHON_PACKAGE));
  process.setProcessEnvironment(environment);
  process.start(QStringLiteral(TETMARCH_PYTHON),
    { script.fileName(), this->Folder.filePath(QStringLiteral("script.png")) });
  QVERIFY(process.waitForStarted(Patience));
#else
  Q_UNUSED(process)
#endif
}

void SavedCase::CheckProgram(QProcess& process, const char* picture)
{
  QVERIFY(process.state() == QProcess::NotRunning || process.waitForFinished(Patience));
  QVERIFY2(process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0,
    process.readAllStandardError().constData());
  this->CheckSame(this->Folder.filePath(QString::fromLatin1(picture)));
}

void SavedCase::CheckSession()
{
  const QString session = this->Folder.filePath(QStringLiteral("session.json"));
  this->Window->SaveSession(session);
  this->OpenPicture(session); // a new window
  const QString drawn = this->Folder.filePath(QStringLiteral("session.png"));
  QVERIFY(this->Window->SaveScreenshot(drawn));
  this->CheckSame(drawn);
}

void SavedCase::CheckSame(const QString& path)
{
  const Difference off = Compare(this->Shown, ReadPng(path));
  QVERIFY2(off.Bytes == 0, qPrintable(QStringLiteral("%1: %2 bytes differ, by up to %3")
                                        .arg(QFileInfo(path).fileName())
                                        .arg(off.Bytes)
                                        .arg(off.Most)));
  QVERIFY(QFile::remove(path)); // the next one is new
}

} // namespace tetmarch
