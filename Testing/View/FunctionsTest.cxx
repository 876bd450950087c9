// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DragMouse.h"
#include "FunctionChart.h"
#include "Programs.h"
#include "TransferFunctionEditor.h"
#include "ViewCase.h"

#include "vtkRenderWindow.h"
#include "vtkVolumeMapper.h"

#include <QAction>
#include <QtTest>

namespace tetmarch
{

/// The editor of transfer functions, and the picture.
class FunctionsTest : public ViewCase
{
  Q_OBJECT

private Q_SLOTS:
  void ADraggedPointChangesThePicture();
  void UndoBringsThePictureBack();
  void OtherDataHaveTheirOwnFunctions();
  void IsoValuesAreLinesOfTheChart();
};
TETMARCH_ADD_SUITE(FunctionsTest);

void FunctionsTest::ADraggedPointChangesThePicture()
{
  this->OpenWindow(GetData("golfball_small.vtu"));
  const Pixels before = this->Draw();
  vtkPiecewiseFunction* opacity = this->GetModel().GetScene().GetOpacity();
  FunctionChart* chart = this->Window->GetFunctions()->GetChart();
  double node[4]; // value, opacity, midpoint, sharpness
  opacity->GetNodeValue(opacity->GetSize() / 2, node);
  const QPoint from = chart->Locate(node[0], node[1]);
  const QPoint to = chart->Locate(node[0], 0.9);
  DragMouse(chart, from, to);
  QVERIFY(!this->GetModel().IsDragging());
  QVERIFY(std::abs(opacity->GetValue(node[0]) - 0.9) < 0.05);
  const Pixels after = this->Draw();
  QVERIFY(Compare(before, after).Most > 10);
}

void FunctionsTest::UndoBringsThePictureBack()
{
  this->OpenWindow(GetData("golfball_small.vtu"));
  const Pixels before = this->Draw();
  auto* editor = this->Window->GetFunctions();
  auto* invert = editor->findChild<QAction*>(QStringLiteral("invert"));
  auto* undo = editor->findChild<QAction*>(QStringLiteral("undo"));
  auto* redo = editor->findChild<QAction*>(QStringLiteral("redo"));
  QVERIFY(invert && undo && redo);
  invert->trigger();
  const Pixels inverted = this->Draw();
  QVERIFY(Compare(before, inverted).Most > 50);
  undo->trigger();
  QCOMPARE(Compare(before, this->Draw()).Bytes, std::size_t(0));
  redo->trigger();
  QCOMPARE(Compare(inverted, this->Draw()).Bytes, std::size_t(0));
}

void FunctionsTest::OtherDataHaveTheirOwnFunctions()
{
  this->OpenWindow(GetData("golfball_small.vtu"));
  auto* editor = this->Window->GetFunctions();
  editor->findChild<QAction*>(QStringLiteral("invert"))->trigger();
  this->Window->Open(GetData("bonsai_small.vti"));
  this->Wait();
  QVERIFY(!editor->findChild<QAction*>(QStringLiteral("undo"))->isEnabled());
  QVERIFY(this->GetModel().GetScene().GetColor()->GetRange()[1] > 100.0); // of bytes
  QVERIFY(CountDrawn(this->Draw()) > 1000);
}

void FunctionsTest::IsoValuesAreLinesOfTheChart()
{
  this->OpenWindow(GetData("golfball_small.vtu"));
  auto* editor = this->Window->GetFunctions();
  QVERIFY(editor->GetIsoValues().empty());
  this->GetModel().Edit(
    [](ViewState& state)
    {
      state.BlendMode = vtkVolumeMapper::ISOSURFACE_BLEND;
      state.IsoValues = { 0.5, 1.0 };
    });
  QCOMPARE(editor->GetIsoValues(), (std::vector<double>{ 0.5, 1.0 }));
  const Pixels before = this->Draw();
  FunctionChart* chart = editor->GetChart();
  chart->renderWindow()->Render(); // with the lines, else VTK waits a moment
  // Away from the curve, whose points would be dragged instead.
  const double height = this->GetModel().GetScene().GetOpacity()->GetValue(0.5) > 0.5 ? 0.15 : 0.85;
  const QPoint from = chart->Locate(0.5, height);
  const QPoint to = chart->Locate(0.8, height);
  DragMouse(chart, from, to);
  const double moved = this->GetModel().GetState().IsoValues[0];
  QVERIFY(std::abs(moved - 0.8) < 0.05);
  QVERIFY(Compare(before, this->Draw()).Most > 10);
}

} // namespace tetmarch

#include "FunctionsTest.moc"
