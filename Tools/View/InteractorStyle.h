// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * VTK's trackball camera, with keys for views, and wheel turns that are drawn exactly at their end.
 */
#ifndef tetmarch_InteractorStyle_h
#define tetmarch_InteractorStyle_h

#include "vtkInteractorStyleTrackballCamera.h"

namespace tetmarch
{
class Model;

class InteractorStyle : public vtkInteractorStyleTrackballCamera
{
public:
  static InteractorStyle* New();
  vtkTypeMacro(InteractorStyle, vtkInteractorStyleTrackballCamera);

  void SetModel(Model* model) { this->Shown = model; }

  void OnChar() override;
  void OnMouseWheelForward() override;
  void OnMouseWheelBackward() override;

private:
  void Zoom(double factor);

  Model* Shown = nullptr;
};

} // namespace tetmarch

#endif
