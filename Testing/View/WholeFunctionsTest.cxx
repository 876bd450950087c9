// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the editor does to whole functions: colour maps, buttons, presets, and others.
#include "EditorUnderTest.h"

#include "ColorMapBox.h"

#include <QFile>
#include <QLabel>
#include <QTemporaryDir>

class WholeFunctionsTest : public QObject
{
  Q_OBJECT

private Q_SLOTS:
  void ColorMapChangesNoOpacity();
  void InvertFitReset();
  void PresetsAreSavedAndLoaded();
  void WhatIsWrongWithAPresetIsSaid();
  void FunctionsFromElsewhere();
};

void WholeFunctionsTest::ColorMapChangesNoOpacity()
{
  EditorUnderTest t;
  const auto before = t.Read();
  auto* const box = t.Editor.findChild<tetmarch::ColorMapBox*>();
  QCOMPARE(box->currentIndex(), -1);
  const int viridis = box->findText("Viridis");
  box->setFocus();
  // As a click on an entry of the list does it.
  Q_EMIT box->activated(viridis);
  const auto after = t.Read();
  QVERIFY(after.Opacities == before.Opacities);
  QCOMPARE(after.Colors.size(), std::size_t(33));
  QCOMPARE(after.Colors.front()[0], 10.0);
  QCOMPARE(after.Colors.back()[0], 20.0);
  QCOMPARE(after.Colors.front()[3], 0.329415);
  QCOMPARE(t.Changed.count(), 1); // with whole functions, not with each point
  QCOMPARE(box->currentIndex(), viridis);
  t.Trigger("undo");
  QVERIFY(t.Read() == before);
  QCOMPARE(box->currentIndex(), -1);
  t.Trigger("redo");
  QCOMPARE(box->currentIndex(), viridis);
  for (int i = 0; i < box->count(); ++i)
  {
    QVERIFY(!box->itemIcon(i).isNull());
  }
}

void WholeFunctionsTest::InvertFitReset()
{
  EditorUnderTest t;
  const auto before = t.Read();
  double old[3];
  double inverted[3];
  t.Trigger("invert");
  vtkNew<vtkColorTransferFunction> color;
  vtkNew<vtkPiecewiseFunction> opacity;
  tetmarch::ApplySnapshot(before, color, opacity);
  for (double x = 10.0; x <= 20.0; x += 0.125)
  {
    color->GetColor(x, old);
    t.Color->GetColor(30.0 - x, inverted);
    for (int i = 0; i < 3; ++i)
    {
      QVERIFY2(std::abs(old[i] - inverted[i]) < 1e-9, qPrintable(QString::number(x)));
    }
  }
  QVERIFY(t.Read().Opacities == before.Opacities);
  t.Trigger("invert");
  QVERIFY(t.Read() == before);
  t.Editor.SetHistogram({ 1.0, 2.0 }, -100.0, 100.0);
  t.Trigger("fit");
  const auto fitted = t.Read();
  QCOMPARE(fitted.Colors.front()[0], -100.0);
  QCOMPARE(fitted.Colors[1][0], -20.0);
  QCOMPARE(fitted.Colors.back()[0], 100.0);
  QCOMPARE(fitted.Opacities[1][0], -40.0);
  QCOMPARE(fitted.Opacities[1][1], 0.5);
  QCOMPARE(fitted.Colors[1][4], 0.25);
  t.Trigger("reset");
  QVERIFY(t.Read() == before);
  QVERIFY(!t.Editor.findChild<QAction*>("reset")->isEnabled());
  t.Trigger("undo");
  QVERIFY(t.Read() == fitted);
}

void WholeFunctionsTest::PresetsAreSavedAndLoaded()
{
  EditorUnderTest t;
  QTemporaryDir folder;
  const QString path = folder.filePath(QString::fromUtf8("M\u00e4rz.json"));
  t.Color->SetNanColor(0.1, 0.2, 0.3);
  t.Color->SetColorSpaceToLab();
  t.Editor.SetFunctions(t.Color, t.Opacity);
  const auto before = t.Read();
  t.Editor.SavePreset(path);
  QVERIFY(QFile::exists(path));
  t.Trigger("invert");
  t.Click(t.Chart()->Locate(17.0, 0.25));
  QVERIFY(t.Read() != before);
  t.Editor.LoadPreset(path);
  auto after = t.Read();
  QVERIFY(after.Colors == before.Colors);
  QVERIFY(after.Opacities == before.Opacities);
  QVERIFY(after.NanColor == before.NanColor);
  QCOMPARE(after.ColorSpace, before.ColorSpace);
  // Over the range that the functions have by then.
  t.Editor.SetHistogram({ 1.0 }, 0.0, 1.0);
  t.Trigger("fit");
  t.Editor.LoadPreset(path);
  QCOMPARE(t.Read().Opacities[1][0], 0.3);
  // A preset of colours leaves the opacity.
  t.Click(t.Chart()->Locate(0.8, 0.25));
  const auto opacities = t.Read().Opacities;
  const QString colors = folder.filePath("colors.json");
  QFile file(colors);
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(R"([{"ColorSpace": "RGB", "RGBPoints": [5, 0, 0, 0, 7, 1, 1, 1]}])");
  file.close();
  t.Editor.LoadPreset(colors);
  after = t.Read();
  QCOMPARE(after.Colors.size(), std::size_t(2));
  QCOMPARE(after.Colors[1][0], 1.0);
  QVERIFY(after.Opacities == opacities);
}

void WholeFunctionsTest::WhatIsWrongWithAPresetIsSaid()
{
  EditorUnderTest t;
  const auto before = t.Read();
  auto* const message = t.Editor.findChild<QLabel*>("message");
  QVERIFY(!message->isVisible());
  t.Editor.LoadPreset("/no/such/preset.json");
  QVERIFY(message->isVisible());
  QVERIFY(message->text().contains("/no/such/preset.json"));
  QVERIFY(t.Read() == before);
  t.Editor.SavePreset("/no/such/folder/preset.json");
  QVERIFY(message->text().contains("/no/such/folder/preset.json"));
  t.Trigger("invert");
  QVERIFY(!message->isVisible());
}

void WholeFunctionsTest::FunctionsFromElsewhere()
{
  EditorUnderTest t;
  // What somebody else does to the functions is told, and can be undone.
  const auto before = t.Read();
  t.Opacity->AddPoint(16.0, 0.1);
  QCOMPARE(t.Changed.count(), 1);
  t.Trigger("undo");
  QVERIFY(t.Read() == before);
  // Other functions have no past, and the older ones are left alone.
  vtkNew<vtkColorTransferFunction> color;
  vtkNew<vtkPiecewiseFunction> opacity;
  color->AddRGBPoint(-1.0, 1.0, 1.0, 1.0);
  opacity->AddPoint(-1.0, 0.5);
  t.Editor.SetFunctions(color, opacity);
  t.Draw(); // of a range without width
  const int told = t.Changed.count();
  QVERIFY(!t.Editor.findChild<QAction*>("undo")->isEnabled());
  t.Opacity->AddPoint(16.0, 0.1);
  QCOMPARE(t.Changed.count(), told);
  // A single colour becomes a map over the histogram, as do functions without points.
  auto* const box = t.Editor.findChild<tetmarch::ColorMapBox*>();
  Q_EMIT box->activated(0);
  QCOMPARE(color->GetRange()[0], 10.0);
  QCOMPARE(color->GetRange()[1], 20.0);
  color->RemoveAllPoints();
  opacity->RemoveAllPoints();
  t.Draw();
  QVERIFY(!t.Chart()->GetHistogram().IsEmpty());
  Q_EMIT box->activated(0);
  t.Draw();
  QCOMPARE(color->GetSize(), 33);
  t.Click(t.Chart()->Locate(15.0, 0.5));
  QCOMPARE(opacity->GetSize(), 1);
}

int RunWholeFunctionsTest(int argc, char** argv)
{
  WholeFunctionsTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "WholeFunctionsTest.moc"
