// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PlayTest.h"

#include "AccuracyPanel.h"
#include "DragMouse.h"
#include "Effect.h"
#include "EffectTimer.h"
#include "EffectsPanel.h"
#include "ErrorTimePlot.h"
#include "PictureWidget.h"
#include "ValueSlider.h"

#include "vtkTetMarchFrameStatistics.h"
#include "vtkTetMarchSettings.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QtTest>

#include <cmath>

namespace
{
using Statistics = vtkTetMarchFrameStatistics;
} // namespace

namespace tetmarch
{

void PlayTest::TheToleranceChangesTheStatistics()
{
  this->OpenWindow(GetData("golfball_small.vtu"));
  Statistics* statistics = this->GetModel().GetScene().GetMapper().GetStatistics();
  QSignalSpy measured(&this->GetModel(), &Model::Measured);
  auto* tolerance = this->Window->findChild<ValueSlider*>(QStringLiteral("tolerance"));
  auto* slider = tolerance->findChild<QSlider*>();
  QTest::keyClick(slider, Qt::Key_End);
  QVERIFY(Reaches(
    [&]
    {
      return measured.count() > 0 && statistics->GetUsedErrorTolerance() > 0.09 &&
             statistics->GetNumberOfPixels(Statistics::LOOKUPS) > 0;
    }));
  const double coarse = statistics->GetMean(Statistics::LOOKUPS);
  const double coarseBound = statistics->GetMaximum(Statistics::ERROR_BOUND);
  measured.clear();
  QTest::keyClick(slider, Qt::Key_Home);
  QVERIFY(Reaches([&] { return measured.count() > 0; }));
  QCOMPARE(statistics->GetUsedErrorTolerance(), 1e-5);
  QVERIFY(statistics->GetMean(Statistics::LOOKUPS) > coarse);
  // What is left is that of the steps of the tables' integrals.
  QVERIFY(statistics->GetMaximum(Statistics::ERROR_BOUND) < 0.1 * coarseBound);
}

void PlayTest::EachSettingIsAPointOfThePlot()
{
  this->OpenWindow(GetData("golfball_small.vtu"));
  ErrorTimePlot* plot = this->Window->GetAccuracy()->GetPlot();
  QVERIFY(Reaches([&] { return plot->GetPoints().size() == 1; }));
  auto* level = this->Window->findChild<QComboBox*>(QStringLiteral("level"));
  QTest::keyClick(level, Qt::Key_Down); // accurate
  QVERIFY(Reaches([&] { return plot->GetPoints().size() == 2; }));
  QVERIFY(plot->GetPoints()[1].Error < plot->GetPoints()[0].Error);
  QVERIFY(plot->GetPoints()[1].Error <= 2.0 / 4096.0); // and the steps of the tables' integrals
}

void PlayTest::TheGroundTruthTellsTheTrueError()
{
  this->OpenWindow(GetData("golfball_small.vtu"));
  this->Window->resize(700, 500);
  this->Wait();
  QVERIFY(this->GetModel().CompareWithGroundTruth());
  Statistics* statistics = this->GetModel().GetScene().GetMapper().GetStatistics();
  QVERIFY(statistics->GetNumberOfPixels(Statistics::TRUE_ERROR) > 1000);
  QVERIFY(statistics->GetMaximum(Statistics::TRUE_ERROR) > 0.0);
  QVERIFY(statistics->GetMaximum(Statistics::TRUE_ERROR) <= 1.0 / 255.0);
}

void PlayTest::ABudgetIsKept()
{
  this->OpenWindow(GetData("golfball_small.vtu"));
  QSignalSpy frames(&this->GetModel(), &Model::Rendered);
  this->GetModel().Edit([](ViewState& s) { s.Accuracy.FrameTime = 1e-6; });
  QVERIFY(Reaches([&] { return frames.count() > 3; })); // by themselves
  Statistics* statistics = this->GetModel().GetScene().GetMapper().GetStatistics();
  QCOMPARE(statistics->GetUsedAccuracyLevel(), int(vtkTetMarchSettings::FAST));
}

void PlayTest::EachEffectChangesThePicture()
{
  this->OpenWindow(GetData("golfball_small.vtu"));
  EffectsPanel* panel = this->Window->GetEffects();
  panel->window()->resize(900, 700);
  this->Wait();
  const Pixels plain = this->Draw();
  for (int i = 0; i < static_cast<int>(GetEffects().size()); ++i)
  {
    const char* name = GetEffects()[i].Name;
    QTest::keyClick(panel->GetCheck(i), Qt::Key_Space);
    panel->GetTimer()->Stop();
    QVERIFY2(panel->GetCheck(i)->isChecked(), name);
    const Difference change = Compare(plain, this->Draw());
    QVERIFY2(change.Bytes > 1000 && change.Most > 5, name);
    QTest::keyClick(panel->GetCheck(i), Qt::Key_Space);
    if (panel->GetCheck(0)->isChecked()) // shading, which light needs
    {
      QTest::keyClick(panel->GetCheck(0), Qt::Key_Space);
    }
    const Difference back = Compare(plain, this->Draw());
    QVERIFY2(back.Bytes == 0, qPrintable(QString::fromLatin1(name) + QString::number(back.Most)));
  }
}

void PlayTest::TheCostOfAnEffectIsMeasured()
{
  this->OpenWindow(GetData("golfball_small.vtu"));
  this->Window->resize(600, 400);
  this->Wait();
  const Pixels plain = this->Draw();
  EffectsPanel* panel = this->Window->GetEffects();
  const QSignalSpy measured(panel->GetTimer(), &EffectTimer::Measured);
  std::vector<bool> lit;
  connect(&this->GetModel(), &Model::Rendered, this,
    [&]
    {
      vtkVolume* volume = this->GetModel().GetScene().GetVolume();
      lit.push_back(volume->GetProperty()->GetShade() != 0);
    });
  panel->GetTimer()->Measure(0);
  QVERIFY(Reaches([&] { return measured.count() == 1; }));
  QVERIFY(!panel->GetTimer()->IsBusy());
  // Three turns, each of two frames without it, the first with it, and another one.
  std::vector<bool> turns;
  for (int turn = 0; turn < 3; ++turn)
  {
    turns.insert(turns.end(), { false, false, true, true });
  }
  QCOMPARE(lit, turns);
  const double added = measured[0][1].toDouble();
  QVERIFY(std::isfinite(added));
  QVERIFY(measured[0][2].toDouble() >= 0.0); // once
  QVERIFY(panel->GetCost(0)->text().contains(QString::number(added, 'f', 3)));
  // The picture is what it was, without the effect.
  QCOMPARE(Compare(plain, this->Draw()).Bytes, std::size_t(0));
}

void PlayTest::EachBlendModeAndViewIsDrawn()
{
  this->OpenWindow(GetData("golfball_small.vtu"));
  for (const char* name : { "blend", "view" })
  {
    auto* choice = this->Window->findChild<QComboBox*>(QString::fromLatin1(name));
    const Pixels plain = this->Draw();
    for (int i = 1; i < choice->count(); ++i)
    {
      QTest::keyClick(choice, Qt::Key_Down);
      QCOMPARE(choice->currentIndex(), i);
      const Pixels drawn = this->Draw();
      QVERIFY(Compare(plain, drawn).Bytes > 1000);
      QVERIFY(CountDrawn(drawn) > 1000);
    }
    QTest::keyClick(choice, Qt::Key_Home);
    QCOMPARE(Compare(plain, this->Draw()).Bytes, std::size_t(0));
  }
}

void PlayTest::CutsTakeSomethingAway()
{
  this->OpenWindow(GetData("bonsai_small.vti"));
  const std::size_t whole = CountDrawn(this->Draw());
  for (const bool crop : { false, true })
  {
    this->GetModel().Edit(
      [&](ViewState& s)
      {
        s.Cuts.Clip = !crop;
        s.Cuts.Crop = crop;
        if (crop) // the lower half
        {
          s.Cuts.Box[1] = (s.Cuts.Box[0] + s.Cuts.Box[1]) / 2.0;
        }
      });
    const QString path = this->Folder.filePath(QStringLiteral("cut.png"));
    QVERIFY(this->Window->SaveScreenshot(path)); // without handles
    const std::size_t left = CountDrawn(ReadPng(path));
    QVERIFY(left > 1000);
    QVERIFY2(left < whole * 9 / 10, qPrintable(QStringLiteral("%1 of %2").arg(left).arg(whole)));
    // The handles are in the picture on the screen.
    this->Wait();
    QVERIFY(Compare(ReadPng(path), this->Draw()).Bytes > 500);
  }
}

void PlayTest::AHandleOfTheBoxIsDragged()
{
  this->OpenWindow(GetData("golfball_small.vtu"));
  this->GetModel().Edit([](ViewState& s) { s.Cuts.Crop = true; });
  this->Wait();
  this->Draw();
  const auto box = this->GetModel().GetState().Cuts.Box;
  PictureWidget* picture = this->Window->GetPicture();
  const auto place = [&](double x) {
    return this->FindPlace({ { x, (box[2] + box[3]) / 2.0, (box[4] + box[5]) / 2.0 } });
  };
  const QPoint handle = place(box[1]); // of the face at the end of x
  const QPoint aim = place(0.4 * box[0] + 0.6 * box[1]);
  QTest::mousePress(picture, Qt::LeftButton, {}, handle);
  for (int i = 1; i <= 4; ++i)
  {
    QMouseEvent move(QEvent::MouseMove, handle + (aim - handle) * i / 4, Qt::NoButton,
      Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(picture, &move);
  }
  QVERIFY(this->GetModel().IsDragging());
  QTest::mouseRelease(picture, Qt::LeftButton, {}, aim);
  QVERIFY(!this->GetModel().IsDragging());
  const auto cut = this->GetModel().GetState().Cuts.Box;
  QVERIFY(cut[1] < box[1] - 1.0 && cut[1] > box[0] + 1.0);
  for (const int side : { 0, 2, 3, 4, 5 })
  {
    QVERIFY(std::abs(cut[side] - box[side]) < 1e-3 * (box[1] - box[0]));
  }
}

void PlayTest::TheLightIsDragged()
{
  this->OpenWindow(GetData("golfball_small.vtu"));
  this->GetModel().Edit([](ViewState& s) { s.Effects.Shading = true; });
  const Pixels before = this->Draw();
  this->Window->GetEffects()->GetHandle()->setChecked(true);
  this->Wait();
  QVERIFY(Compare(before, this->Draw()).Bytes > 100); // the ball
  const Vector3 from = this->GetModel().GetState().Effects.LightFrom;
  const auto bounds = this->GetModel().GetScene().GetBounds();
  const double reach = 0.4 * this->GetModel().GetScene().GetDiagonal();
  const double length = std::sqrt(from[0] * from[0] + from[1] * from[1] + from[2] * from[2]);
  PictureWidget* picture = this->Window->GetPicture();
  Vector3 ball;
  for (int i = 0; i < 3; ++i)
  {
    ball[i] = (bounds[2 * i] + bounds[2 * i + 1]) / 2.0 + reach * from[i] / length;
  }
  const QPoint place = this->FindPlace(ball);
  DragMouse(picture, place, place + QPoint(120, 60));
  QVERIFY(!this->GetModel().IsDragging());
  const Vector3 turned = this->GetModel().GetState().Effects.LightFrom;
  const double cosine = (from[0] * turned[0] + from[1] * turned[1] + from[2] * turned[2]) / length;
  QVERIFY2(cosine < 0.99, qPrintable(QString::number(cosine)));
  this->Window->GetEffects()->GetHandle()->setChecked(false);
  this->Wait();
  QVERIFY(Compare(before, this->Draw()).Most > 10); // other light, without the ball
}

void PlayTest::AClickFindsACell()
{
  this->OpenWindow(GetData("bonsai_small.vti"));
  const Pixels before = this->Draw();
  auto* text = this->Window->findChild<QLabel*>(QStringLiteral("pick"));
  PictureWidget* picture = this->Window->GetPicture();
  QTest::mouseClick(picture, Qt::LeftButton, {}, picture->rect().center());
  QVERIFY2(QRegularExpression(QStringLiteral("^cell \\d+, position [-.\\de]+ [-.\\de]+ "
                                             "[-.\\de]+, \\S+ [-.\\de]+$"))
             .match(text->text())
             .hasMatch(),
    qPrintable(text->text()));
  QTest::mouseClick(picture, Qt::LeftButton, {}, QPoint(3, 3));
  QVERIFY(text->text().startsWith(QLatin1String("nothing")));
  QCOMPARE(Compare(before, this->Draw()).Bytes, std::size_t(0));
}

void PlayTest::ADragTurnsAndIsExactAtItsEnd()
{
  this->OpenWindow(GetData("golfball_small.vtu"));
  const Pixels before = this->Draw();
  PictureWidget* picture = this->Window->GetPicture();
  Statistics* statistics = this->GetModel().GetScene().GetMapper().GetStatistics();
  const QPoint middle = picture->rect().center();
  QTest::mousePress(picture, Qt::LeftButton, {}, middle);
  double coarsest = 1.0;
  double slowest = 0.0; // of frames with a ray for each pixel
  for (int i = 1; i <= 10; ++i)
  {
    // QTest::mouseMove() has no button down.
    QMouseEvent move(QEvent::MouseMove, middle + QPoint(8 * i, 3 * i), Qt::NoButton, Qt::LeftButton,
      Qt::NoModifier);
    QCoreApplication::sendEvent(picture, &move);
    const double distance = statistics->GetUsedImageSampleDistance();
    coarsest = std::max(coarsest, distance);
    slowest = distance == 1.0 ? std::max(slowest, statistics->GetSeconds()) : slowest;
  }
  QTest::mouseRelease(picture, Qt::LeftButton, {}, middle + QPoint(80, 30));
  // A GPU is fast enough for all rays.
  QVERIFY(coarsest > 1.0 || slowest < 0.2);
  this->Wait();
  QCOMPARE(statistics->GetUsedImageSampleDistance(), 1.0);
  QVERIFY(Compare(before, this->Draw()).Bytes > 1000);
  QVERIFY(this->Window->findChild<QLabel*>(QStringLiteral("pick"))->text().isEmpty());
}

void PlayTest::KeysLookAlongAxes()
{
  this->OpenWindow(GetData("golfball_small.vtu"));
  PictureWidget* picture = this->Window->GetPicture();
  const CameraState first = this->GetModel().GetState().Camera;
  const char keys[] = { 'x', 'y', 'z' };
  for (int axis = 0; axis < 3; ++axis)
  {
    QTest::keyClick(picture, keys[axis]);
    const CameraState camera = this->GetModel().GetState().Camera;
    for (int other = 0; other < 3; ++other)
    {
      const double along = camera.Position[other] - camera.FocalPoint[other];
      QVERIFY(other == axis ? std::abs(along) > 1.0 : std::abs(along) < 1e-9);
    }
  }
  QTest::keyClick(picture, '5');
  QVERIFY(this->GetModel().GetState().Camera.Parallel);
  QTest::keyClick(picture, '5');
  QVERIFY(!this->GetModel().GetState().Camera.Parallel);
  QTest::keyClick(picture, 'r');
  const CameraState reset = this->GetModel().GetState().Camera;
  for (int i = 0; i < 3; ++i)
  {
    QVERIFY(std::abs(reset.Position[i] - first.Position[i]) < 1e-9);
  }
  for (const char key : { 'q', 'e', '3' }) // neither ends the program nor breaks the picture
  {
    QTest::keyClick(picture, key);
  }
  QVERIFY(this->Window->isVisible());
}

} // namespace tetmarch
