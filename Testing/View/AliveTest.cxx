// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HeldFrame.h"
#include "PictureWidget.h"
#include "Programs.h"
#include "ViewCase.h"

#include "vtkTetMarchFrameStatistics.h"
#include "vtkTetMarchSettings.h"

#include <QPushButton>
#include <QTimer>
#include <QtTest>

namespace
{
constexpr int Few = 3; // events, and reports of progress
} // namespace

namespace tetmarch
{

/// Nothing blocks the window: neither a long frame nor the ground truth.
class AliveTest : public ViewCase
{
  Q_OBJECT

private Q_SLOTS:
  void HandlesEventsDuringAFrame();
  void CancelsAFrame();
  void ASettingStopsTheFrame();
  void DataStopsTheFrame();
  void AScreenshotIsWhole();
  void AResizedWindowIsDrawnAnew();
  void ClosesDuringAFrame();
  void HandlesEventsDuringTheGroundTruth();
  void CancelsTheGroundTruth();

private:
  /// Draws in the smallest tiles, so that a frame can be held between two of them.
  void MakeTiles();
  QPushButton* FindCancel();
  /// Calls it as soon as a frame, or a comparison, tells of its progress.
  void During(const std::function<void()>& what);

  bool Happened = false; // what During() was given
};
TETMARCH_ADD_SUITE(AliveTest);

QPushButton* AliveTest::FindCancel()
{
  return this->Window->findChild<QPushButton*>(QStringLiteral("cancel"));
}

void AliveTest::MakeTiles()
{
  this->GetModel().GetScene().GetMapper().GetSettings()->SetMaxDrawTimeInSeconds(1e-9);
}

void AliveTest::During(const std::function<void()>& what)
{
  this->Happened = false;
  auto* once = new QObject(this);
  connect(&this->GetModel(), &Model::DrawingProgressed, once,
    [this, once, what](const QString&, double share)
    {
      if (share <= 1.0)
      {
        delete once;
        QTimer::singleShot(0, this,
          [this, what]
          {
            what();
            this->Happened = true;
          });
      }
    });
}

void AliveTest::HandlesEventsDuringAFrame()
{
  this->OpenLattice();
  this->MakeTiles();
  const QSignalSpy told(&this->GetModel(), &Model::DrawingProgressed);
  QTimer timer;
  const QSignalSpy rounds(&timer, &QTimer::timeout);
  timer.start(0);
  {
    const HeldFrame held(
      this->GetModel(), [&] { return rounds.count() >= Few && told.count() >= Few; });
    this->GetModel().Render();
  }
  QVERIFY(!this->GetModel().WasStopped());
  QVERIFY(rounds.count() >= Few);
  QVERIFY(told.count() >= Few);
  QVERIFY(told.last()[1].toDouble() > 1.0);
  QVERIFY(!this->FindCancel()->isVisible());
  // The same picture as in one go.
  const Pixels handled = this->Draw();
  this->GetModel().GetScene().GetMapper().GetSettings()->SetMaxDrawTimeInSeconds(0.0);
  QCOMPARE(Compare(handled, this->Draw()).Bytes, std::size_t(0));
}

void AliveTest::CancelsAFrame()
{
  this->OpenLattice();
  this->Draw();
  this->Wait();
  const QImage before = this->Window->GetPicture()->grabFramebuffer();
  const QSignalSpy frames(&this->GetModel(), &Model::Rendered);
  this->MakeTiles();
  const HeldFrame held(this->GetModel(), [] { return false; });
  this->During(
    [this]
    {
      QVERIFY(this->FindCancel()->isVisible());
      QTest::mouseClick(this->FindCancel(), Qt::LeftButton);
    });
  this->GetModel().Edit([](ViewState& s) { s.Effects.Shading = true; });
  QVERIFY(Reaches([this] { return this->GetModel().WasStopped(); }));
  this->Wait();
  QVERIFY(!this->FindCancel()->isVisible());
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
  this->OpenLattice();
  this->MakeTiles();
  const HeldFrame held(this->GetModel(), [] { return false; });
  this->During(
    [this]
    {
      this->GetModel().Edit(
        [](ViewState& s) { s.Settings.AccuracyLevel = vtkTetMarchSettings::FAST; });
    });
  this->GetModel().Render();
  QVERIFY(this->Happened);
  QVERIFY(this->GetModel().WasStopped());
  const QSignalSpy frames(&this->GetModel(), &Model::Rendered);
  QVERIFY(Reaches([&] { return frames.count() > 0; }));
  QCOMPARE(this->GetModel().GetState().Settings.AccuracyLevel, int(vtkTetMarchSettings::FAST));
}

void AliveTest::DataStopsTheFrame()
{
  this->OpenLattice();
  this->MakeTiles();
  {
    const HeldFrame held(this->GetModel(), [] { return false; });
    this->During([this] { this->Window->Open(GetData("bonsai_small.vti")); });
    this->GetModel().Render();
  }
  QVERIFY(this->Happened);
  QVERIFY(this->GetModel().WasStopped());
  QVERIFY(Reaches(
    [this] { return this->Window->windowTitle().contains(QLatin1String("bonsai_small.vti")); }));
  this->Wait();
  QVERIFY(CountDrawn(this->Draw()) > 1000);
}

void AliveTest::AScreenshotIsWhole()
{
  this->OpenLattice();
  this->MakeTiles();
  const Pixels wanted = this->Draw();
  const QString path = this->Folder.filePath(QStringLiteral("shot.png"));
  {
    const HeldFrame held(this->GetModel(), [this] { return this->Happened; });
    this->During([this] { QTest::keyClick(this->Window->GetPicture(), Qt::Key_X); });
    QVERIFY(this->Window->SaveScreenshot(path));
  }
  QVERIFY(this->Happened);
  QCOMPARE(Compare(wanted, ReadPng(path)).Bytes, std::size_t(0));
  // What waited is done afterwards.
  this->Wait();
  QVERIFY(Compare(wanted, this->Draw()).Bytes > 1000);
}

void AliveTest::AResizedWindowIsDrawnAnew()
{
  this->OpenPicture(GetData("golfball_small.vtu"));
  for (const QSize& size : { QSize(400, 300), QSize(500, 400) })
  {
    const QSignalSpy frames(&this->GetModel(), &Model::Rendered);
    this->Window->resize(size);
    QVERIFY(Reaches([&] { return frames.count() > 0; }));
    this->Wait();
    const QImage seen = this->Window->GetPicture()->grabFramebuffer();
    this->Draw();
    QCOMPARE(this->Window->GetPicture()->grabFramebuffer(), seen);
    QCOMPARE(seen.size(), this->Window->GetPicture()->size());
  }
}

void AliveTest::ClosesDuringAFrame()
{
  this->OpenLattice();
  this->MakeTiles();
  const HeldFrame held(this->GetModel(), [] { return false; });
  this->During([this] { this->Window->close(); });
  this->GetModel().Render();
  QVERIFY(this->GetModel().WasStopped());
  QVERIFY(Reaches([this] { return !this->Window->isVisible(); }));
}

void AliveTest::HandlesEventsDuringTheGroundTruth()
{
  this->OpenLattice();
  this->Window->resize(240, 200); // each pixel takes long
  this->Wait();
  const QSignalSpy told(&this->GetModel(), &Model::DrawingProgressed);
  QTimer timer;
  const QSignalSpy rounds(&timer, &QTimer::timeout);
  timer.start(0);
  const HeldFrame held(
    this->GetModel(), [&] { return rounds.count() >= Few && told.count() >= Few; });
  QVERIFY(this->GetModel().CompareWithGroundTruth());
  QVERIFY(rounds.count() >= Few);
  QVERIFY(told.count() >= Few);
}

void AliveTest::CancelsTheGroundTruth()
{
  this->OpenLattice();
  this->Draw();
  auto* compare = this->Window->findChild<QPushButton*>(QStringLiteral("compare"));
  const QImage before = this->Window->GetPicture()->grabFramebuffer();
  const HeldFrame held(this->GetModel(), [] { return false; });
  this->During([this] { QTest::mouseClick(this->FindCancel(), Qt::LeftButton); });
  compare->click();
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

#include "AliveTest.moc"
