// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A ball in the picture, on the side of the volume that the light comes from. The user drags it
 * around the volume.
 */
#ifndef tetmarch_LightHandle_h
#define tetmarch_LightHandle_h

#include "ViewState.h"

#include "vtkHandleWidget.h"
#include "vtkNew.h"
#include "vtkSphereHandleRepresentation.h"

#include <functional>

class vtkRenderWindowInteractor;
class vtkRenderer;

namespace tetmarch
{

class LightHandle
{
public:
  /// moved: with where the light comes from, a unit vector; true while the user drags.
  LightHandle(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer,
    std::function<void(const Vector3& from, bool dragging)> moved);
  LightHandle(const LightHandle&) = delete;
  LightHandle& operator=(const LightHandle&) = delete;
  ~LightHandle();

  /// Of the data, around whose middle the ball is turned.
  void SetBounds(const double bounds[6]);
  void Show(const Vector3& from);
  void Hide();

private:
  void Tell(bool dragging);

  std::function<void(const Vector3&, bool)> Moved;
  vtkNew<vtkSphereHandleRepresentation> Ball;
  vtkNew<vtkHandleWidget> Widget;
  Vector3 Centre{ { 0.0, 0.0, 0.0 } };
  double Distance = 1.0; // of the ball from it
  bool Telling = false;
};

} // namespace tetmarch

#endif
