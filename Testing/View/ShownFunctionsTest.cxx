// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the editor's chart shows: histogram, isovalues, colours, any range, any palette.
#include "EditorUnderTest.h"

#include "vtkPlotArea.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <QImage>

class ShownFunctionsTest : public QObject
{
  Q_OBJECT

private Q_SLOTS:
  void HistogramIsLogarithmicIfAsked();
  void IsoValuesAreDragged();
  void ValuesThatFloatsCannotTellApart();
  void BarHasTheColorsOfTheVolume();
  void PaletteIsTheWidgets();
};

void ShownFunctionsTest::HistogramIsLogarithmicIfAsked()
{
  EditorUnderTest t;
  const auto readTable = [&]
  {
    vtkTable* const table = t.Chart()->GetHistogram().GetPlot()->GetInput();
    std::vector<double> heights;
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); row += 2)
    {
      heights.push_back(table->GetValue(row, 2).ToDouble());
    }
    return heights;
  };
  const std::vector<double> linear{ 1.0, 0.1, 0.01, 0.001, 0.0 };
  QVERIFY(readTable() == linear);
  const QImage before = t.Chart()->grabFramebuffer();
  t.Trigger("logarithmic");
  const auto heights = readTable();
  QCOMPARE(heights[0], 1.0);
  QCOMPARE(heights[1], std::log(101.0) / std::log(1001.0));
  QCOMPARE(heights[4], 0.0);
  QVERIFY(t.Chart()->grabFramebuffer() != before);
  QCOMPARE(t.Changed.count(), 0);
  t.Trigger("logarithmic");
  QVERIFY(readTable() == linear);
  QVERIFY(t.Chart()->grabFramebuffer() == before);
  t.Editor.SetHistogram({}, 0.0, 1.0);
  t.Draw();
  QVERIFY(!t.Editor.findChild<QAction*>("logarithmic")->isEnabled());
}

void ShownFunctionsTest::IsoValuesAreDragged()
{
  EditorUnderTest t;
  const auto before = t.Read();
  t.Editor.SetIsoValues({ 12.0, 18.0 });
  t.Draw();
  QCOMPARE(t.IsoValuesChanged.count(), 0);
  const QPoint from = t.Chart()->Locate(18.0, 0.3);
  t.Drag(from, from - QPoint(60, 10));
  const auto values = t.Editor.GetIsoValues();
  QCOMPARE(values.size(), std::size_t(2));
  QCOMPARE(values[0], 12.0);
  QVERIFY(std::abs(values[1] - (18.0 - 60 * t.GetPixelWidth())) < 1.5 * t.GetPixelWidth());
  QVERIFY(t.IsoValuesChanged.count() >= 10);
  QCOMPARE(t.DragBegan.count(), 1);
  QCOMPARE(t.DragEnded.count(), 1);
  QCOMPARE(t.Changed.count(), 0);
  QVERIFY(t.Read() == before); // no point was added
  t.Trigger("undo");
  QVERIFY((t.Editor.GetIsoValues() == std::vector<double>{ 12.0, 18.0 }));
  // A point lies above a line.
  t.Editor.SetIsoValues({ 13.0 });
  t.Draw();
  const QPoint point = t.Chart()->Locate(13.0, 0.5);
  t.Drag(point, point + QPoint(30, 0));
  QCOMPARE(t.Editor.GetIsoValues()[0], 13.0);
  QVERIFY(t.Read().Opacities[1][0] > 13.2);
  // Isovalues from elsewhere survive an undo.
  t.Editor.SetIsoValues({ 15.0 });
  t.Trigger("undo");
  QCOMPARE(t.Editor.GetIsoValues()[0], 15.0);
  QVERIFY(t.Read() == before);
}

void ShownFunctionsTest::ValuesThatFloatsCannotTellApart()
{
  EditorUnderTest t;
  for (const double low : { 16777216.0, -3e-12 })
  {
    const double width = low > 0.0 ? 1.0 : 1e-12; // floats at 2^24 are 2 apart
    vtkNew<vtkColorTransferFunction> color;
    vtkNew<vtkPiecewiseFunction> opacity;
    color->AddRGBPoint(low, 0.0, 0.0, 0.0);
    color->AddRGBPoint(low + width, 1.0, 1.0, 1.0);
    opacity->AddPoint(low, 0.0);
    opacity->AddPoint(low + 0.25 * width, 0.5);
    opacity->AddPoint(low + width, 1.0);
    t.Editor.SetHistogram({}, 0.0, 0.0);
    t.Editor.SetIsoValues({ low + 0.75 * width });
    t.Editor.SetFunctions(color, opacity);
    t.Draw();
    const QPoint point = t.Chart()->Locate(low + 0.25 * width, 0.5);
    t.Drag(point, t.Chart()->Locate(low + 0.5 * width, 0.5));
    double node[4];
    opacity->GetNodeValue(1, node);
    QVERIFY(std::abs((node[0] - low) / width - 0.5) < 0.01);
    t.Drag(t.Chart()->Locate(low + 0.75 * width, 0.2), t.Chart()->Locate(low + 0.9 * width, 0.2));
    QVERIFY(std::abs((t.Editor.GetIsoValues()[0] - low) / width - 0.9) < 0.01);
    QCOMPARE(opacity->GetSize(), 3);
    t.Editor.SetIsoValues({});
  }
}

void ShownFunctionsTest::BarHasTheColorsOfTheVolume()
{
  EditorUnderTest t;
  vtkNew<vtkColorTransferFunction> color;
  color->SetScaleToLog10();
  color->AddRGBPoint(1.0, 0.0, 0.0, 1.0);
  color->AddRGBPoint(10.0, 0.0, 1.0, 0.0);
  color->AddRGBPoint(1000.0, 1.0, 0.0, 0.0);
  t.Editor.SetHistogram({}, 0.0, 0.0);
  t.Opacity->RemoveAllPoints();
  t.Opacity->AddPoint(1.0, 1.0);
  t.Opacity->AddPoint(1000.0, 1.0);
  t.Editor.SetFunctions(color, t.Opacity);
  t.Draw();
  const QImage picture = t.Chart()->grabFramebuffer();
  for (const double value : { 100.0, 300.0, 600.0, 900.0 })
  {
    double rgb[3];
    color->GetColor(value, rgb);
    // Beside the points, and below the curve.
    for (const QPoint& place :
      { t.Chart()->LocateInBar(value) + QPoint(0, 8), t.Chart()->Locate(value, 0.5) })
    {
      const QColor pixel = picture.pixelColor(place * picture.devicePixelRatio());
      QVERIFY2(std::abs(pixel.redF() - rgb[0]) < 0.03, qPrintable(QString::number(value)));
      QVERIFY2(std::abs(pixel.greenF() - rgb[1]) < 0.03, qPrintable(QString::number(value)));
    }
  }
  // A point that is added changes nothing but that it is there.
  t.Click(t.Chart()->LocateInBar(100.0));
  QCOMPARE(color->GetSize(), 4);
  QVERIFY(std::abs(color->GetRedValue(100.0) - 0.5) < 0.02);
  QVERIFY(std::abs(color->GetGreenValue(100.0) - 0.5) < 0.02);
}

void ShownFunctionsTest::PaletteIsTheWidgets()
{
  EditorUnderTest t;
  for (const QColor& base : { QColor(20, 30, 40), QColor(250, 240, 230) })
  {
    QPalette palette;
    palette.setColor(QPalette::Base, base);
    t.Editor.setPalette(palette);
    t.Draw();
    const QColor corner = t.Chart()->grabFramebuffer().pixelColor(1, 1);
    QVERIFY(std::abs(corner.red() - base.red()) <= 1);
    QVERIFY(std::abs(corner.blue() - base.blue()) <= 1);
  }
}

int RunShownFunctionsTest(int argc, char** argv)
{
  ShownFunctionsTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "ShownFunctionsTest.moc"
