// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AliveTest.h"

#include "PictureWidget.h"
#include "Rounds.h"
#include "WriteGrids.h"

#include "vtkTetMarchFrameStatistics.h"
#include "vtkTetMarchSettings.h"

#include <QPushButton>
#include <QTimer>
#include <QtTest>

namespace
{
constexpr int Patience = 120000;
constexpr int Cells = 60; // along an axis of a lattice that takes a while
constexpr int Little = 5; // events that are handled at least during long work
} // namespace

namespace tetmarch
{

QPushButton* AliveTest::FindCancel()
{
  return this->Window->findChild<QPushButton*>(QStringLiteral("cancel"));
}

void AliveTest::MakeFramesLong()
{
  this->GetModel().Edit(
    [](ViewState& s)
    {
      s.Accuracy.Level = vtkTetMarchSettings::REFERENCE;
      s.Effects.Shading = true;
    });
  this->GetModel().GetScene().GetMapper().GetSettings()->SetMaxDrawTimeInSeconds(0.02);
}

void AliveTest::During(const std::function<void()>& what)
{
  auto* once = new QObject(this);
  connect(&this->GetModel(), &Model::DrawingProgressed, once,
    [once, what](const QString&, double share)
    {
      if (share <= 1.0)
      {
        delete once;
        QTimer::singleShot(0, what);
      }
    });
}

void AliveTest::HandlesEventsDuringAFrame()
{
  this->OpenWindow(WriteLattice(this->Folder.filePath(QStringLiteral("big.vtu")), Cells));
  this->MakeFramesLong();
  QSignalSpy told(&this->GetModel(), &Model::DrawingProgressed);
  const Rounds rounds;
  this->GetModel().Render();
  QVERIFY(!this->GetModel().WasStopped());
  QVERIFY(rounds.Count >= Little);
  QVERIFY(told.count() >= Little);
  QVERIFY(told.last()[1].toDouble() > 1.0);
  QVERIFY(!this->FindCancel()->isVisible());
  // The same picture as in one go.
  const Pixels handled = this->Draw();
  this->GetModel().GetScene().GetMapper().GetSettings()->SetMaxDrawTimeInSeconds(0.0);
  QCOMPARE(Compare(handled, this->Draw()).Bytes, std::size_t(0));
}

void AliveTest::CancelsAFrame()
{
  this->OpenWindow(WriteLattice(this->Folder.filePath(QStringLiteral("big.vtu")), Cells));
  this->Draw();
  this->Wait();
  const QImage before = this->Window->GetPicture()->grabFramebuffer();
  QSignalSpy frames(&this->GetModel(), &Model::Rendered);
  this->During(
    [this]
    {
      QVERIFY(this->FindCancel()->isVisible());
      QTest::mouseClick(this->FindCancel(), Qt::LeftButton);
    });
  this->MakeFramesLong();
  QTRY_VERIFY_WITH_TIMEOUT(this->GetModel().WasStopped(), Patience);
  QTRY_VERIFY(!this->FindCancel()->isVisible());
  QTest::qWait(1500);
  QCOMPARE(frames.count(), 0);
  QVERIFY(!this->GetModel().IsDrawing());
  QCOMPARE(this->Window->GetPicture()->grabFramebuffer(), before);
  // The settings have changed all the same.
  this->GetModel().Render();
  QCOMPARE(frames.count(), 1);
  QVERIFY(this->Window->GetPicture()->grabFramebuffer() != before);
}

void AliveTest::ASettingStopsTheFrame()
{
  this->OpenWindow(WriteLattice(this->Folder.filePath(QStringLiteral("big.vtu")), Cells));
  this->MakeFramesLong();
  bool edited = false;
  this->During(
    [&]
    {
      this->GetModel().Edit([](ViewState& s) { s.Accuracy.Level = vtkTetMarchSettings::FAST; });
      edited = true;
    });
  this->GetModel().Render();
  QVERIFY(edited);
  QVERIFY(this->GetModel().WasStopped());
  QSignalSpy frames(&this->GetModel(), &Model::Rendered);
  QTRY_VERIFY_WITH_TIMEOUT(frames.count() > 0, Patience);
  QCOMPARE(this->GetModel().GetState().Accuracy.Level, int(vtkTetMarchSettings::FAST));
}

void AliveTest::DataStopsTheFrame()
{
  this->OpenWindow(WriteLattice(this->Folder.filePath(QStringLiteral("big.vtu")), Cells));
  this->MakeFramesLong();
  this->During([this] { this->Window->Open(GetData("bonsai_small.vti")); });
  this->GetModel().Render();
  this->Wait();
  QTRY_VERIFY_WITH_TIMEOUT(
    this->Window->windowTitle().contains(QLatin1String("bonsai_small.vti")), Patience);
  QVERIFY(CountDrawn(this->Draw()) > 1000);
}

void AliveTest::AScreenshotIsWhole()
{
  this->OpenWindow(WriteLattice(this->Folder.filePath(QStringLiteral("big.vtu")), Cells));
  this->MakeFramesLong();
  const Pixels wanted = this->Draw();
  bool pressed = false;
  this->During(
    [&]
    {
      pressed = true;
      QTest::keyClick(this->Window->GetPicture(), Qt::Key_X);
    });
  const QString path = this->Folder.filePath(QStringLiteral("shot.png"));
  QVERIFY(this->Window->SaveScreenshot(path));
  QVERIFY(pressed);
  QCOMPARE(Compare(wanted, ReadPng(path)).Bytes, std::size_t(0));
  // What waited is done afterwards.
  this->Wait();
  QVERIFY(Compare(wanted, this->Draw()).Bytes > 1000);
}

void AliveTest::AResizedWindowIsDrawnAnew()
{
  this->OpenWindow(GetData("golfball_small.vtu"));
  for (const QSize& size : { QSize(900, 700), QSize(1000, 800) })
  {
    this->Window->resize(size);
    QTest::qWait(1000);
    const QImage seen = this->Window->GetPicture()->grabFramebuffer();
    this->Draw();
    QCOMPARE(this->Window->GetPicture()->grabFramebuffer(), seen);
    QCOMPARE(seen.size(), this->Window->GetPicture()->size());
  }
}

void AliveTest::ClosesDuringAFrame()
{
  this->OpenWindow(WriteLattice(this->Folder.filePath(QStringLiteral("big.vtu")), Cells));
  this->MakeFramesLong();
  this->During([this] { this->Window->close(); });
  this->GetModel().Render();
  QVERIFY(this->GetModel().WasStopped());
  QTRY_VERIFY(!this->Window->isVisible());
}

void AliveTest::HandlesEventsDuringTheGroundTruth()
{
  this->OpenWindow(GetData("golfball_small.vtu"));
  this->Window->resize(700, 500);
  this->Wait();
  QSignalSpy told(&this->GetModel(), &Model::DrawingProgressed);
  const Rounds rounds;
  QVERIFY(this->GetModel().CompareWithGroundTruth());
  QVERIFY(rounds.Count >= Little);
  QVERIFY(told.count() >= Little);
}

void AliveTest::CancelsTheGroundTruth()
{
  this->OpenWindow(GetData("golfball_small.vtu"));
  this->Draw();
  auto* compare = this->Window->findChild<QPushButton*>(QStringLiteral("compare"));
  const QImage before = this->Window->GetPicture()->grabFramebuffer();
  this->During([this] { QTest::mouseClick(this->FindCancel(), Qt::LeftButton); });
  QTest::mouseClick(compare, Qt::LeftButton);
  QVERIFY(this->GetModel().WasStopped());
  this->Wait();
  QVERIFY(!this->FindCancel()->isVisible());
  QVERIFY(this->TakeMessage().isEmpty());
  QCOMPARE(this->Window->GetPicture()->grabFramebuffer(), before);
  using Statistics = vtkTetMarchFrameStatistics;
  Statistics* statistics = this->GetModel().GetScene().GetMapper().GetStatistics();
  QCOMPARE(statistics->GetNumberOfPixels(Statistics::TRUE_ERROR), vtkTypeInt64(0));
}

} // namespace tetmarch
