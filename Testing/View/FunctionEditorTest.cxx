// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The editor of transfer functions, by events of mouse and keyboard that Qt delivers to it.
#include "EditorUnderTest.h"

#include <QColorDialog>
#include <QDoubleSpinBox>
#include <QToolButton>

class FunctionEditorTest : public QObject
{
  Q_OBJECT

private Q_SLOTS:
  void DragOfOpacityPoint();
  void EndPointsMoveUpAndDownOnly();
  void ClickAddsPoint();
  void MiddleClickAndKeyDelete();
  void LettersAreNoCommands();
  void ColorPointsAreDraggedAddedAndDeleted();
  void ColorDialogIsOneStep();
  void UndoAndRedo();
  void HandlesOfMidpointAndSharpness();
  void SpinBoxes();
};

void FunctionEditorTest::DragOfOpacityPoint()
{
  EditorUnderTest t;
  QVERIFY(t.Shown);
  const auto before = t.Read();
  const QPoint from = t.Chart()->Locate(13.0, 0.5);
  t.Drag(from, from + QPoint(40, -30));
  const auto after = t.Read();
  QCOMPARE(after.Opacities.size(), before.Opacities.size());
  QVERIFY(after.Opacities[0] == before.Opacities[0]);
  QVERIFY(after.Opacities[2] == before.Opacities[2]);
  QVERIFY(
    std::abs(after.Opacities[1][0] - (13.0 + 40 * t.GetPixelWidth())) < 1.5 * t.GetPixelWidth());
  QVERIFY(
    std::abs(after.Opacities[1][1] - (0.5 + 30 * t.GetPixelHeight())) < 1.5 * t.GetPixelHeight());
  QVERIFY(after.Colors == before.Colors);
  QVERIFY(t.Changed.count() >= 10); // while it was dragged, not only at the end
  QCOMPARE(t.DragBegan.count(), 1);
  QCOMPARE(t.DragEnded.count(), 1);
  QCOMPARE(t.IsoValuesChanged.count(), 0);
  t.Trigger("undo"); // one step
  QVERIFY(t.Read() == before);
  QVERIFY(!t.Editor.findChild<QAction*>("undo")->isEnabled());
}

void FunctionEditorTest::EndPointsMoveUpAndDownOnly()
{
  EditorUnderTest t;
  const QPoint from = t.Chart()->Locate(20.0, 1.0);
  t.Drag(from, from + QPoint(-50, 40));
  const auto after = t.Read();
  QCOMPARE(after.Opacities[2][0], 20.0);
  QVERIFY(
    std::abs(after.Opacities[2][1] - (1.0 - 40 * t.GetPixelHeight())) < 1.5 * t.GetPixelHeight());
}

void FunctionEditorTest::ClickAddsPoint()
{
  EditorUnderTest t;
  const auto before = t.Read();
  t.Click(t.Chart()->Locate(17.0, 0.25));
  const auto after = t.Read();
  QCOMPARE(after.Opacities.size(), std::size_t(4));
  QVERIFY(std::abs(after.Opacities[2][0] - 17.0) < t.GetPixelWidth());
  QVERIFY(std::abs(after.Opacities[2][1] - 0.25) < t.GetPixelHeight());
  QVERIFY(after.Colors == before.Colors);
  QVERIFY(t.Changed.count() >= 1);
  QVERIFY(t.Chart()->GetChosenPoint().Of == tetmarch::ControlPoint::Kind::Opacity);
  QCOMPARE(t.Chart()->GetChosenPoint().Index, 2);
}

void FunctionEditorTest::MiddleClickAndKeyDelete()
{
  EditorUnderTest t;
  const auto before = t.Read();
  t.Click(t.Chart()->Locate(13.0, 0.5), Qt::MiddleButton);
  QCOMPARE(t.Read().Opacities.size(), std::size_t(2));
  t.Trigger("undo");
  QVERIFY(t.Read() == before);
  t.Click(t.Chart()->Locate(13.0, 0.5));
  QVERIFY(t.Read() == before); // it is chosen, no more
  QTest::keyClick(t.Chart(), Qt::Key_Delete);
  QCOMPARE(t.Read().Opacities.size(), std::size_t(2));
  t.Trigger("undo");
  QVERIFY(t.Read() == before);
  // The ends stay.
  t.Click(t.Chart()->Locate(10.0, 0.0));
  QTest::keyClick(t.Chart(), Qt::Key_Delete);
  t.Click(t.Chart()->Locate(20.0, 1.0), Qt::MiddleButton);
  QVERIFY(t.Read() == before);
}

void FunctionEditorTest::LettersAreNoCommands()
{
  EditorUnderTest t;
  const auto before = t.Read();
  for (const char letter : { 'q', 'e', 'r', 's', 'w', '3', 'p' })
  {
    QTest::keyClick(t.Chart(), letter);
  }
  t.Draw();
  QVERIFY(t.Read() == before);
  t.Click(t.Chart()->Locate(17.0, 0.25));
  QCOMPARE(t.Read().Opacities.size(), std::size_t(4)); // the chart still listens
}

void FunctionEditorTest::ColorPointsAreDraggedAddedAndDeleted()
{
  EditorUnderTest t;
  const auto before = t.Read();
  const QPoint from = t.Chart()->LocateInBar(14.0);
  t.Drag(from, from + QPoint(50, 0));
  auto after = t.Read();
  QVERIFY(std::abs(after.Colors[1][0] - (14.0 + 50 * t.GetPixelWidth())) < 1.5 * t.GetPixelWidth());
  QCOMPARE(after.Colors[1][1], 0.9);
  QVERIFY(after.Opacities == before.Opacities);
  QCOMPARE(t.DragEnded.count(), 1);
  double expected[3];
  const QPoint added = t.Chart()->LocateInBar(12.0);
  t.Color->GetColor(12.0, expected);
  t.Click(added);
  after = t.Read();
  QCOMPARE(after.Colors.size(), std::size_t(4));
  QVERIFY(std::abs(after.Colors[1][0] - 12.0) < t.GetPixelWidth());
  QVERIFY(std::abs(after.Colors[1][1] - expected[0]) < 0.03); // no other colour than there was
  QVERIFY(after.Opacities == before.Opacities);
  t.Click(t.Chart()->LocateInBar(12.0), Qt::MiddleButton);
  QCOMPARE(t.Read().Colors.size(), std::size_t(3));
  for (int i = 0; i < 3; ++i)
  {
    t.Trigger("undo");
  }
  QVERIFY(t.Read() == before);
}

void FunctionEditorTest::ColorDialogIsOneStep()
{
  EditorUnderTest t;
  const auto before = t.Read();
  const QPoint place = t.Chart()->LocateInBar(14.0);
  t.Click(place);
  QVERIFY(t.Editor.findChild<QToolButton*>("color")->isVisible());
  t.Send(QEvent::MouseButtonDblClick, place, Qt::LeftButton, Qt::LeftButton);
  t.Send(QEvent::MouseButtonRelease, place, Qt::LeftButton, Qt::NoButton);
  auto* dialog = t.Editor.findChild<QColorDialog*>();
  QVERIFY(dialog && dialog->isVisible());
  QVERIFY(std::abs(dialog->currentColor().redF() - 0.9) < 0.01);
  dialog->setCurrentColor(QColor(0, 255, 0));
  dialog->setCurrentColor(QColor(0, 51, 255));
  QVERIFY(std::abs(t.Read().Colors[1][2] - 0.2) < 1e-4);
  QCOMPARE(t.Changed.count(), 2);
  dialog->accept();
  t.Trigger("undo");
  QVERIFY(t.Read() == before);
  t.Trigger("redo");
  t.Click(place);
  t.Editor.findChild<QToolButton*>("color")->click();
  QTRY_COMPARE_WITH_TIMEOUT(t.Editor.findChildren<QColorDialog*>().count(), 1, Patience);
  dialog = t.Editor.findChild<QColorDialog*>();
  dialog->setCurrentColor(QColor(255, 255, 255));
  dialog->reject();
  QVERIFY(std::abs(t.Read().Colors[1][2] - 0.2) < 1e-4);
}

void FunctionEditorTest::UndoAndRedo()
{
  EditorUnderTest t;
  QVERIFY(t.Shown);
  std::vector<tetmarch::FunctionSnapshot> states = { t.Read() };
  const QPoint from = t.Chart()->Locate(13.0, 0.5);
  t.Drag(from, from + QPoint(-30, 20));
  states.push_back(t.Read());
  t.Click(t.Chart()->Locate(17.0, 0.25));
  states.push_back(t.Read());
  t.Trigger("invert");
  states.push_back(t.Read());
  for (int i = 2; i >= 0; --i)
  {
    QTest::keyClick(&t.Editor, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY2(t.Read() == states[i], qPrintable(QString::number(i)));
  }
  QVERIFY(!t.Editor.findChild<QAction*>("undo")->isEnabled());
  for (int i = 1; i <= 3; ++i)
  {
    QTest::keyClick(&t.Editor, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY2(t.Read() == states[i], qPrintable(QString::number(i)));
  }
  QVERIFY(!t.Editor.findChild<QAction*>("redo")->isEnabled());
  // What is done after an undo takes the place of what was undone.
  t.Trigger("undo");
  t.Click(t.Chart()->Locate(11.0, 0.75));
  QVERIFY(!t.Editor.findChild<QAction*>("redo")->isEnabled());
  t.Trigger("undo");
  QVERIFY(t.Read() == states[2]);
}

void FunctionEditorTest::HandlesOfMidpointAndSharpness()
{
  EditorUnderTest t;
  const auto before = t.Read();
  const QPoint place = t.Chart()->Locate(13.0, 0.5);
  t.Click(place);
  t.Send(QEvent::MouseButtonDblClick, place, Qt::LeftButton, Qt::LeftButton);
  t.Send(QEvent::MouseButtonRelease, place, Qt::LeftButton, Qt::NoButton);
  t.Draw();
  QVERIFY(t.Read() == before);
  // The right handle is where the curve to the next point is half way.
  t.Drag(t.Chart()->Locate(16.5, 0.5), t.Chart()->Locate(18.25, 0.5));
  const auto midpoint = t.Read().Opacities[1];
  QCOMPARE(midpoint[0], 13.0);
  QVERIFY(std::abs(midpoint[2] - 0.75) < t.GetPixelWidth());
  QVERIFY(t.Changed.count() >= 5);
  QCOMPARE(t.DragEnded.count(), 1);
  t.Trigger("undo");
  QVERIFY(t.Read() == before);
}

void FunctionEditorTest::SpinBoxes()
{
  EditorUnderTest t;
  const auto before = t.Read();
  const auto box = [&](const char* name) { return t.Editor.findChild<QDoubleSpinBox*>(name); };
  QVERIFY(!box("opacity")->isEnabled());
  t.Click(t.Chart()->Locate(13.0, 0.5));
  QVERIFY(box("opacity")->isEnabled());
  QCOMPARE(box("value")->value(), 13.0);
  QCOMPARE(box("opacity")->value(), 0.5);
  box("opacity")->setValue(0.625);
  box("midpoint")->setValue(0.25);
  box("sharpness")->setValue(0.75);
  box("value")->selectAll();
  QTest::keyClicks(box("value"), "1.25e1");
  QTest::keyClick(box("value"), Qt::Key_Return);
  const std::array<double, 4> expected{ { 12.5, 0.625, 0.25, 0.75 } };
  QVERIFY(t.Read().Opacities[1] == expected);
  QCOMPARE(t.Changed.count(), 4);
  box("value")->setValue(1000.0); // no farther than the next point
  QCOMPARE(t.Read().Opacities[1][0], 20.0);
  // A run through many values is one step.
  t.Trigger("undo");
  QVERIFY(t.Read().Opacities[1][0] != 20.0);
  t.Click(t.Chart()->LocateInBar(14.0));
  QVERIFY(!box("opacity")->isVisible());
  QCOMPARE(box("midpoint")->value(), 0.25);
  for (int i = 0; i < 5; ++i)
  {
    box("sharpness")->stepUp();
  }
  QVERIFY(std::abs(t.Read().Colors[1][5] - 0.55) < 1e-12);
  t.Trigger("undo");
  QVERIFY(t.Read().Colors == before.Colors);
}

int RunMouseTest(int argc, char** argv)
{
  FunctionEditorTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "FunctionEditorTest.moc"
