// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SessionTest.h"

#include "Failure.h"
#include "PythonScript.h"
#include "RenderCommand.h"
#include "ViewStateJson.h"

#include "vtkTetMarchSettings.h"

#include <QFile>
#include <QFileInfo>
#include <QMessageBox>
#include <QProcess>
#include <QtTest>

namespace
{
using namespace tetmarch;

constexpr int Patience = 1000000; // milliseconds, for a program

/// All but the first are changes that a row of a test makes.
struct Change
{
  const char* Name;
  const char* File;
  void (*Make)(ViewState&);
};

void DoNothing(ViewState&) {}

void Light(ViewState& s)
{
  s.Effects.Shading = true;
  s.Effects.Shadows = vtkTetMarchSettings::SHADOWS_AT_VERTICES;
  s.Effects.Occlusion = true;
  s.Effects.Scattering = true;
  s.Effects.LightFrom = { { -1.0, 0.3, 0.8 } };
}

void Cut(ViewState& s)
{
  s.Cuts.Clip = true;
  s.Cuts.Normal = { { -0.6, 0.0, 0.8 } };
  s.Cuts.Crop = true;
  s.Cuts.Box[1] = 0.3 * s.Cuts.Box[0] + 0.7 * s.Cuts.Box[1];
  s.Background = { { 0.9, 0.8, 0.7 } };
}

void MakeSurfaces(ViewState& s)
{
  s.BlendMode = 5;
  s.Effects.Shading = true;
  s.Effects.Headlight = true;
}

void ShowCells(ViewState& s)
{
  s.ViewMode = vtkTetMarchSettings::VIEW_CELLS;
  s.Camera.Parallel = true;
  s.Accuracy.Level = vtkTetMarchSettings::ACCURATE;
}

void Turn(ViewState& s)
{
  s.Camera.Position = { { 1.0 / 3.0, -13.7, 4.4 } };
  s.Camera.ViewUp = { { 0.1, 0.2, 0.9 } };
  s.Camera.ViewAngle = 41.0;
  s.Accuracy.Tolerance = 1e-4;
  s.Functions.UnitDistance /= 3.0;
  s.Functions.Color[0] = { { s.Functions.Color[0][0], 0.1, 1.0 / 3.0, 1.0, 0.5, 0.0 } };
}

constexpr Change Changes[] = { { "first", "golfball_small.vtu", DoNothing },
  { "turned", "golfball_small.vtu", Turn }, { "light", "golfball_small.vtu", Light },
  { "cut", "golfball_small.vtu", Cut }, { "cells", "golfball_small.vtu", ShowCells },
  { "isosurfaces", "golfball_small.vtu", MakeSurfaces }, { "image", "bonsai_small.vti", DoNothing },
  { "lit image", "bonsai_small.vti", Light }, { "cut image", "bonsai_small.vti", Cut },
  { "sampled image", "bonsai_small.vti",
    [](ViewState& s) { s.Accuracy.Level = vtkTetMarchSettings::SAMPLED; } },
  { "gradient opacity", "golfball_small.vtu",
    [](ViewState& s) { s.Effects.GradientOpacity = true; } },
  { "voxels", "bonsai_small.vti", [](ViewState& s) { s.Data.Nearest = true; } } };

void RunProgram(
  const QString& program, const QStringList& arguments, const QProcessEnvironment& environment)
{
  QProcess process;
  process.setProcessEnvironment(environment);
  process.start(program, arguments);
  QVERIFY(process.waitForFinished(Patience));
  QVERIFY2(process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0,
    process.readAllStandardError().constData());
}
} // namespace

namespace tetmarch
{

void SessionTest::TakePicture()
{
  const QString path = this->Folder.filePath(QStringLiteral("shown.png"));
  QVERIFY(this->Window->SaveScreenshot(path));
  this->Shown = ReadPng(path);
  QVERIFY(CountDrawn(this->Shown) > 1000);
}

void SessionTest::CheckSame(const QString& path)
{
  const Difference off = Compare(this->Shown, ReadPng(path));
  QVERIFY2(off.Bytes == 0, qPrintable(QStringLiteral("%1: %2 bytes differ, by up to %3")
                                        .arg(QFileInfo(path).fileName())
                                        .arg(off.Bytes)
                                        .arg(off.Most)));
}

void SessionTest::AStateComesBackFromItsText()
{
  ViewState state;
  const std::string first = WriteState(state);
  state.Data.File = "a folder/it's \"é\".vtu";
  state.Data.TimeStep = 7;
  state.Data.Component = -1;
  state.Functions.Color = { { { 0.1, 1.0 / 3.0, 0.0, 1.0, 0.5, 0.25 } } };
  state.Functions.ColorSpace = 3;
  state.Functions.Opacity = { { { -1e-300, 0.0, 0.5, 0.0 } }, { { 1e300, 1.0, 0.1, 0.9 } } };
  state.Camera.Position = { { 0.1, 0.2, 1.0 / 7.0 } };
  state.IsoValues = { 1.0, 1.0 / 3.0 };
  state.BlendMode = 5;
  Light(state);
  Cut(state);
  ShowCells(state);
  const std::string text = WriteState(state);
  QVERIFY(text != first);
  state.Data.Array = "caf\xe9"; // a name of a file that knows no UTF-8
  QCOMPARE(ReadState(WriteState(state)).Data.Array, std::string("caf\xef\xbf\xbd"));
  QVERIFY(WriteScript(state, false).find("caf\xef\xbf\xbd") != std::string::npos);
  const ViewState read = ReadState(text);
  QCOMPARE(WriteState(read), text);
  QCOMPARE(read.Camera.Position[2], 1.0 / 7.0);
  QCOMPARE(read.Functions.Opacity[0][0], -1e-300);
  QCOMPARE(read.Effects.Shadows, state.Effects.Shadows);
}

void SessionTest::BadSessionsAreRefused()
{
  this->OpenPicture(GetData("bonsai_small.vti"));
  const Pixels before = this->Draw();
  const QString path = this->Folder.filePath(QStringLiteral("bad.json"));
  const QByteArray kind = "{\"kind\": \"tetmarch-view session\", ";
  const std::pair<QByteArray, const char*> texts[] = { { "{", "not JSON" },
    { "[1, 2]", "lacks \"kind\"" }, { kind + "\"camera\": 3}", "camera must be an object" },
    { kind + "\"accuracy\": {\"tolerance\": \"x\"}}", "tolerance is \"x\"" },
    { kind + "\"picture\": {\"blend\": \"mixed\"}}", "blend is \"mixed\"" },
    { kind + "\"camera\": {\"position\": [1, 2]}}", "position is [1,2]" } };
  for (const auto& [text, why] : texts)
  {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(text);
    file.close();
    this->Window->Open(path);
    const QString message = this->TakeMessage();
    QVERIFY2(message.contains(path) && message.contains(QLatin1String(why)), qPrintable(message));
  }
  QCOMPARE(Compare(before, this->Draw()).Bytes, std::size_t(0));
}

void SessionTest::WhatIsSavedDrawsTheSamePicture_data()
{
  QTest::addColumn<int>("change");
  for (int i = 0; i < static_cast<int>(std::size(Changes)); ++i)
  {
    QTest::newRow(Changes[i].Name) << i;
  }
}

void SessionTest::WhatIsSavedDrawsTheSamePicture()
{
  QFETCH(int, change);
  this->OpenPicture(GetData(Changes[change].File));
  this->GetModel().Edit(Changes[change].Make);
  this->Wait();
  this->TakePicture();
  this->CheckCommand();
  this->CheckScript();
  this->CheckSession();
}

void SessionTest::CheckSession()
{
  const QString session = this->Folder.filePath(QStringLiteral("session.json"));
  this->Window->SaveSession(session);
  this->OpenPicture(session); // a new window
  const QString drawn = this->Folder.filePath(QStringLiteral("session.png"));
  QVERIFY(this->Window->SaveScreenshot(drawn));
  this->CheckSame(drawn);
}

void SessionTest::CheckCommand()
{
  const QString drawn = this->Folder.filePath(QStringLiteral("command.png"));
  const std::string command = WriteCommand(this->GetModel().GetState(), drawn.toStdString());
  QVERIFY(command.find("#") == std::string::npos); // nothing is left out
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert(QStringLiteral("PATH"), QStringLiteral(TETMARCH_BIN ":") + qgetenv("PATH"));
  environment.insert(QStringLiteral("TETMARCH_GL"), QStringLiteral("egl"));
  environment.remove(QStringLiteral("DISPLAY"));
  RunProgram(QStringLiteral("/bin/sh"), { QStringLiteral("-c"), QString::fromStdString(command) },
    environment);
  this->CheckSame(drawn);
}

void SessionTest::CheckScript()
{
#ifdef TETMARCH_PYTHON
  const QString drawn = this->Folder.filePath(QStringLiteral("script.png"));
  QFile script(this->Folder.filePath(QStringLiteral("script.py")));
  QVERIFY(script.open(QIODevice::WriteOnly));
  script.write(this->Window->GetPythonScript().toUtf8());
  script.close();
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert(QStringLiteral("PYTHONPATH"), QStringLiteral(TETMARCH_PYTHON_PACKAGE));
  RunProgram(QStringLiteral(TETMARCH_PYTHON), { script.fileName(), drawn }, environment);
  this->CheckSame(drawn);
#endif
}

void SessionTest::OddNamesAreQuoted()
{
  const QString path = this->Folder.filePath(QStringLiteral("it's a $HOME \\ \"tree\".vti"));
  QVERIFY(QFile::copy(GetData("bonsai_small.vti"), path));
  this->OpenPicture(path);
  this->TakePicture();
  this->CheckCommand();
  this->CheckScript();
}

} // namespace tetmarch
