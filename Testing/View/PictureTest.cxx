// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DragMouse.h"
#include "EffectsPanel.h"
#include "PictureWidget.h"
#include "Programs.h"
#include "ScarceTime.h"
#include "ViewCase.h"

#include "vtkTetMarchFrameStatistics.h"

#include <QCheckBox>
#include <QLabel>
#include <QtTest>

#include <algorithm>
#include <cmath>

namespace tetmarch
{

/// What the user sees and does in the picture. Also run on a screen with twice the pixels.
class PictureTest : public ViewCase
{
  Q_OBJECT

private Q_SLOTS:
  void ItIsOnTheScreen();
  void AHandleOfTheBoxIsDragged();
  void TheLightIsDragged();
  void AClickFindsACell();
  void ADragTurnsAndIsExactAtItsEnd();
  void KeysLookAlongAxes();
};
TETMARCH_ADD_SUITE(PictureTest);

void PictureTest::ItIsOnTheScreen()
{
  this->OpenLattice();
  const Pixels pixels = this->Draw();
  QVERIFY(CountDrawn(pixels) > pixels.Bytes.size() / 3 / 50);
  const QImage seen = this->Window->GetPicture()->grabFramebuffer();
  QCOMPARE(seen.width(), pixels.Width);
  QCOMPARE(seen.height(), pixels.Height);
  std::size_t off = 0;
  for (int y = 0; y < seen.height(); ++y)
  {
    for (int x = 0; x < seen.width(); ++x)
    {
      const QRgb color = seen.pixel(x, y);
      const auto* drawn = &pixels.Bytes[3 * ((pixels.Height - 1 - y) * pixels.Width + x)];
      off += qRed(color) != drawn[0] || qGreen(color) != drawn[1] || qBlue(color) != drawn[2];
    }
  }
  QCOMPARE(off, std::size_t(0));
}

void PictureTest::AHandleOfTheBoxIsDragged()
{
  this->OpenLattice();
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
  const double length = box[1] - box[0];
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
  QVERIFY(cut[1] < box[1] - 0.1 * length && cut[1] > box[0] + 0.1 * length);
  for (const int side : { 0, 2, 3, 4, 5 })
  {
    QVERIFY(std::abs(cut[side] - box[side]) < 1e-3 * length);
  }
}

void PictureTest::TheLightIsDragged()
{
  this->OpenLattice();
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

void PictureTest::AClickFindsACell()
{
  this->OpenPicture(GetData("bonsai_small.vti"));
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

void PictureTest::ADragTurnsAndIsExactAtItsEnd()
{
  this->OpenLattice();
  const Pixels before = this->Draw();
  PictureWidget* picture = this->Window->GetPicture();
  testing::makeTimeScarce(this->GetModel().GetScene().GetRenderer());
  vtkTetMarchFrameStatistics* statistics = this->GetModel().GetScene().GetMapper().GetStatistics();
  const QPoint middle = picture->rect().center();
  QTest::mousePress(picture, Qt::LeftButton, {}, middle);
  double coarsest = 1.0;
  for (int i = 1; i <= 10; ++i)
  {
    // QTest::mouseMove() has no button down.
    QMouseEvent move(QEvent::MouseMove, middle + QPoint(8 * i, 3 * i), Qt::NoButton, Qt::LeftButton,
      Qt::NoModifier);
    QCoreApplication::sendEvent(picture, &move);
    coarsest = std::max(coarsest, statistics->GetUsedImageSampleDistance());
  }
  QTest::mouseRelease(picture, Qt::LeftButton, {}, middle + QPoint(80, 30));
  QVERIFY(coarsest > 1.0);
  this->Wait();
  QCOMPARE(statistics->GetUsedImageSampleDistance(), 1.0);
  QVERIFY(Compare(before, this->Draw()).Bytes > 1000);
  QVERIFY(this->Window->findChild<QLabel*>(QStringLiteral("pick"))->text().isEmpty());
}

void PictureTest::KeysLookAlongAxes()
{
  this->OpenLattice();
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

#include "PictureTest.moc"
