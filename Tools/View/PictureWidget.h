// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The picture in the window: turned by the mouse as VTK's trackball does it, and clicked on.
 */
#ifndef tetmarch_PictureWidget_h
#define tetmarch_PictureWidget_h

#include <QPoint>
#include <QVTKOpenGLNativeWidget.h>

#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkNew.h"

namespace tetmarch
{
class Model;

class PictureWidget : public QVTKOpenGLNativeWidget
{
  Q_OBJECT

public:
  explicit PictureWidget(Model& model, QWidget* parent = nullptr);

Q_SIGNALS:
  /// Not the end of a drag. Pixels of the window, from the lower left.
  void Clicked(int x, int y);

protected:
  void paintGL() override;
  void resizeGL(int width, int height) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

private:
  vtkNew<vtkGenericOpenGLRenderWindow> Own;
  Model& Shown;
  QPoint Pressed;
};

} // namespace tetmarch

#endif
