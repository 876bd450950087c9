// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A plane and a box in the picture that the user takes hold of.
 */
#ifndef tetmarch_CutWidgets_h
#define tetmarch_CutWidgets_h

#include "ViewState.h"

#include "vtkBoxRepresentation.h"
#include "vtkBoxWidget2.h"
#include "vtkImplicitPlaneRepresentation.h"
#include "vtkImplicitPlaneWidget2.h"
#include "vtkNew.h"

#include <functional>

class vtkRenderWindowInteractor;
class vtkRenderer;

namespace tetmarch
{

class CutWidgets
{
public:
  /// moved: with what the widgets have become; true while the user drags.
  CutWidgets(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer,
    std::function<void(const CutState& cuts, bool dragging)> moved);
  CutWidgets(const CutWidgets&) = delete;
  CutWidgets& operator=(const CutWidgets&) = delete;
  ~CutWidgets();

  /// Of the data: what surrounds the plane.
  void SetBounds(const double bounds[6]);
  /// Show what of them is on, where it is. What the user holds stays as it is.
  void Show(const CutState& cuts);
  void Hide();

private:
  void Tell(bool dragging);

  std::function<void(const CutState&, bool)> Moved;
  vtkNew<vtkImplicitPlaneRepresentation> Plane;
  vtkNew<vtkImplicitPlaneWidget2> PlaneWidget;
  vtkNew<vtkBoxRepresentation> Box;
  vtkNew<vtkBoxWidget2> BoxWidget;
  CutState Shown;
  bool Telling = false;
};

} // namespace tetmarch

#endif
