// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Programs.h"
#include "SessionKeeper.h"
#include "ViewCase.h"
#include "ViewStateJson.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QLabel>
#include <QProcess>
#include <QToolBar>
#include <QtTest>

#include <cstdio>
#include <unistd.h>

namespace
{
using namespace tetmarch;

constexpr int Patience = 300000;

QStringList FindSessions(const QString& folder)
{
  return QDir(folder).entryList({ QStringLiteral("*.json") });
}

QString ReadText(SessionKeeper& keeper) { return keeper.GetOffer()->findChild<QLabel*>()->text(); }

void EditScene(ViewState& s)
{
  s.Camera.Position = { { 300.0, -200.0, 100.0 } };
  s.Effects.Shading = true;
  s.Background = { { 0.9, 0.8, 0.7 } };
}
} // namespace

namespace tetmarch
{

/// What is left of a session if the program dies, and what the next one does with it.
class CrashTest : public ViewCase
{
  Q_OBJECT

public:
  /// A program with a session, whose picture it saves in a folder. Then it reads a file, says so,
  /// and waits to be killed.
  static int ReadUntilKilled(const QStringList& arguments);

private Q_SLOTS:
  void AKilledProgramsSessionIsRestored();
  void ANormalEndLeavesNothing();
  void OneWindowOffersIt();
  void AnOfferIsDiscarded();
  void AnOfferLetsAFileBeOpened();
  void ASessionThatFailsIsOfferedAgain();
  void WhatIsNoSessionIsNotOffered();
  void AFolderThatIsNotWrittenTo();

private:
  /// A new folder with one session that nobody owns: of a scan, as if it were in that file.
  QString AbandonSession(const char* data);
  void Press(SessionKeeper& keeper, const char* button);
};
TETMARCH_ADD_SUITE(CrashTest);
[[maybe_unused]] static const bool IsAdded =
  AddProgram("--until-killed", CrashTest::ReadUntilKilled);

int CrashTest::ReadUntilKilled(const QStringList& arguments)
{
  const QString folder = arguments.last();
  MainWindow window;
  HidePanels(window);
  window.show();
  const SessionKeeper keeper(window, folder + QStringLiteral("/kept"));
  window.Open(GetData("bonsai_small.vti"));
  Model& model = window.GetModel();
  const auto atRest = [&] { return !model.GetLoader().IsBusy() && !model.HasFramesToDraw(); };
  Reaches(atRest);
  model.Edit(EditScene);
  Reaches(atRest);
  window.SaveScreenshot(folder + QStringLiteral("/before.png"));
  model.GetLoader().SetWatch(
    [](const std::string& stage, double fraction)
    {
      if (stage == "reading" && fraction > 0.3)
      {
        std::puts("reads");
        std::fflush(stdout);
        while (true)
        {
          pause();
        }
      }
    });
  window.Open(GetData("golfball_small.vtu"));
  return QApplication::exec();
}

QString CrashTest::AbandonSession(const char* data)
{
  const QString folder = this->Folder.filePath(QString::fromLatin1(QTest::currentTestFunction()));
  QDir().mkpath(folder);
  this->OpenPicture(GetData("bonsai_small.vti"));
  ViewState state = this->GetModel().GetState();
  state.Data.File = GetData(data).toStdString();
  state.Background = { { 0.9, 0.8, 0.7 } };
  SaveSession(state, (folder + QStringLiteral("/1-abandoned.json")).toStdString());
  return folder;
}

void CrashTest::Press(SessionKeeper& keeper, const char* button)
{
  keeper.GetOffer()->findChild<QAction*>(QString::fromLatin1(button))->trigger();
}

void CrashTest::AKilledProgramsSessionIsRestored()
{
  const QString kept = this->Folder.filePath(QStringLiteral("kept"));
  QProcess program;
  program.start(
    QApplication::applicationFilePath(), { QStringLiteral("--until-killed"), this->Folder.path() });
  QByteArray told;
  while (!told.contains("reads"))
  {
    QVERIFY(program.waitForReadyRead(Patience));
    told += program.readAllStandardOutput();
  }
  QCOMPARE(FindSessions(kept).size(), 1);
  this->ShowEmptyWindow();
  {
    SessionKeeper whileItLives(*this->Window, kept);
    QVERIFY(!whileItLives.GetOffer());
  }
  program.kill(); // SIGKILL: it does nothing more
  QVERIFY(program.waitForFinished(Patience));
  QCOMPARE(program.exitStatus(), QProcess::CrashExit);

  SessionKeeper keeper(*this->Window, kept);
  QVERIFY(keeper.GetOffer());
  QVERIFY(
    Reaches([&] { return keeper.GetOffer()->isVisible(); })); // a new bar is shown by an event
  QVERIFY(ReadText(keeper).contains(QLatin1String("bonsai_small.vti")));
  this->Press(keeper, "restore");
  QVERIFY(!keeper.GetOffer()->isVisible());
  HidePanels(*this->Window); // the bar has made it wider
  this->Wait();
  const QString after = this->Folder.filePath(QStringLiteral("after.png"));
  QVERIFY(this->Window->SaveScreenshot(after));
  const Pixels before = ReadPng(this->Folder.filePath(QStringLiteral("before.png")));
  QVERIFY(CountDrawn(before) > 1000);
  QCOMPARE(Compare(before, ReadPng(after)).Bytes, std::size_t(0));
  QCOMPARE(FindSessions(kept).size(), 1); // this window's own
}

void CrashTest::ANormalEndLeavesNothing()
{
  const QString kept = this->Folder.filePath(QStringLiteral("normal"));
  this->OpenPicture(GetData("bonsai_small.vti"));
  {
    const SessionKeeper keeper(*this->Window, kept);
    const SessionKeeper another(*this->Window, kept); // as another window has one
    this->Window->Open(GetData("bonsai_small.vti"));
    QCOMPARE(FindSessions(kept).size(), 2);
    this->Wait();
  }
  QVERIFY(QDir(kept).isEmpty());
}

void CrashTest::OneWindowOffersIt()
{
  const QString kept = this->AbandonSession("bonsai_small.vti");
  this->ShowEmptyWindow();
  {
    SessionKeeper first(*this->Window, kept);
    SessionKeeper second(*this->Window, kept);
    QVERIFY(first.GetOffer() && !second.GetOffer());
  }
  SessionKeeper later(*this->Window, kept); // nobody has answered
  QVERIFY(later.GetOffer());
}

void CrashTest::AnOfferIsDiscarded()
{
  const QString kept = this->AbandonSession("bonsai_small.vti");
  this->ShowEmptyWindow();
  {
    SessionKeeper keeper(*this->Window, kept);
    this->Press(keeper, "discard");
    QVERIFY(!keeper.GetOffer()->isVisible());
    QVERIFY(!this->GetModel().GetLoader().IsBusy());
  }
  QVERIFY(QDir(kept).isEmpty());
}

void CrashTest::AnOfferLetsAFileBeOpened()
{
  const QString kept = this->AbandonSession("bonsai_small.vti");
  this->ShowEmptyWindow();
  SessionKeeper keeper(*this->Window, kept);
  this->Window->Open(GetData("golfball_small.vtu"));
  this->Wait();
  QVERIFY(CountDrawn(this->Draw()) > 1000);
  QVERIFY(keeper.GetOffer()->isVisible());
  this->Press(keeper, "restore");
  this->Wait();
  QVERIFY(this->Window->windowTitle().contains(QLatin1String("bonsai_small.vti")));
  QVERIFY(FindSessions(kept).size() == 1); // the window's own
  QCOMPARE(this->GetModel().GetState().Background[0], 0.9);
}

void CrashTest::ASessionThatFailsIsOfferedAgain()
{
  const QString kept = this->AbandonSession("no_such_file.vti");
  this->ShowEmptyWindow();
  {
    SessionKeeper keeper(*this->Window, kept);
    this->Press(keeper, "restore");
    QVERIFY(Reaches([this] { return !this->GetModel().GetLoader().IsBusy(); }));
    QVERIFY(this->TakeMessage().contains(QLatin1String("no_such_file.vti")));
  }
  SessionKeeper later(*this->Window, kept);
  QVERIFY(later.GetOffer());
}

void CrashTest::WhatIsNoSessionIsNotOffered()
{
  const QString kept = this->AbandonSession("bonsai_small.vti");
  QFile cut(kept + QStringLiteral("/1-abandoned.json"));
  QVERIFY(cut.resize(cut.size() / 2));
  this->ShowEmptyWindow();
  SessionKeeper keeper(*this->Window, kept);
  QVERIFY(!keeper.GetOffer());
  QVERIFY(QDir(kept).isEmpty());
}

void CrashTest::AFolderThatIsNotWrittenTo()
{
  QFile file(this->Folder.filePath(QStringLiteral("file")));
  QVERIFY(file.open(QIODevice::WriteOnly));
  this->OpenPicture(GetData("bonsai_small.vti"));
  SessionKeeper keeper(*this->Window, file.fileName() + QStringLiteral("/below"));
  this->Window->Open(GetData("bonsai_small.vti")); // goes on with a warning
  this->Wait();
  QVERIFY(CountDrawn(this->Draw()) > 1000);
}

} // namespace tetmarch

#include "CrashTest.moc"
