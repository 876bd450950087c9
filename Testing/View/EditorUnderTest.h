// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * An editor on the screen, with functions whose points a test knows, and a mouse for it.
 */
#ifndef EditorUnderTest_h
#define EditorUnderTest_h

#include "DragMouse.h"
#include "FunctionChart.h"
#include "FunctionSnapshot.h"
#include "TransferFunctionEditor.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderWindow.h"

#include <QAction>
#include <QApplication>
#include <QSignalSpy>
#include <QtTest>

constexpr int Patience = 300000; // milliseconds: on any machine something is wrong then

struct EditorUnderTest
{
  EditorUnderTest()
  {
    this->Color->AddRGBPoint(10.0, 0.0, 0.0, 1.0);
    this->Color->AddRGBPoint(14.0, 0.9, 0.9, 0.9, 0.25, 0.5);
    this->Color->AddRGBPoint(20.0, 1.0, 0.0, 0.0);
    this->Opacity->AddPoint(10.0, 0.0);
    this->Opacity->AddPoint(13.0, 0.5);
    this->Opacity->AddPoint(20.0, 1.0);
    this->Editor.SetFunctions(this->Color, this->Opacity);
    this->Editor.SetHistogram({ 1000.0, 100.0, 10.0, 1.0, 0.0 }, 10.0, 20.0);
    this->Editor.resize(350, 420);
    this->Editor.show();
    this->Shown = QTest::qWaitForWindowExposed(&this->Editor, Patience) && this->Activate();
    this->Chart()->setFocus();
    this->Draw();
  }

  /**
   * Asks for the keyboard and waits until the X server has given it: keys of actions reach the
   * active window only. A window that isn't exposed yet may not ask, and the one before may lose it
   * late.
   */
  bool Activate()
  {
    this->Editor.activateWindow();
    return QTest::qWaitForWindowActive(&this->Editor, Patience);
  }

  tetmarch::FunctionSnapshot Read() { return tetmarch::TakeSnapshot(this->Color, this->Opacity); }

  void Draw()
  {
    QCoreApplication::processEvents();
    this->Chart()->renderWindow()->Render(); // else VTK waits a moment
  }

  tetmarch::FunctionChart* Chart() { return this->Editor.GetChart(); }

  void Trigger(const char* name)
  {
    auto* const action = this->Editor.findChild<QAction*>(name);
    QVERIFY2(action && action->isEnabled(), name);
    action->trigger();
    this->Draw();
  }

  void Send(
    QEvent::Type type, const QPoint& place, Qt::MouseButton button, Qt::MouseButtons buttons)
  {
    tetmarch::SendMouse(this->Chart(), type, place, button, buttons);
  }

  void Click(const QPoint& place, Qt::MouseButton button = Qt::LeftButton)
  {
    this->Send(QEvent::MouseMove, place, Qt::NoButton, Qt::NoButton);
    this->Send(QEvent::MouseButtonPress, place, button, button);
    this->Send(QEvent::MouseButtonRelease, place, button, Qt::NoButton);
    this->Draw();
  }

  void Drag(const QPoint& from, const QPoint& to)
  {
    tetmarch::DragMouse(this->Chart(), from, to);
    this->Draw();
  }

  /// How many units of value a pixel is wide, and of opacity high.
  double GetPixelWidth()
  {
    const int wide = this->Chart()->Locate(20.0, 0.0).x() - this->Chart()->Locate(10.0, 0.0).x();
    return 10.0 / wide;
  }
  double GetPixelHeight()
  {
    return 1.0 / (this->Chart()->Locate(10.0, 0.0).y() - this->Chart()->Locate(10.0, 1.0).y());
  }

  vtkNew<vtkColorTransferFunction> Color;
  vtkNew<vtkPiecewiseFunction> Opacity;
  tetmarch::TransferFunctionEditor Editor;
  QSignalSpy Changed{ &Editor, &tetmarch::TransferFunctionEditor::Changed };
  QSignalSpy DragBegan{ &Editor, &tetmarch::TransferFunctionEditor::DragBegan };
  QSignalSpy DragEnded{ &Editor, &tetmarch::TransferFunctionEditor::DragEnded };
  QSignalSpy IsoValuesChanged{ &Editor, &tetmarch::TransferFunctionEditor::IsoValuesChanged };
  bool Shown = false;
};

#endif
