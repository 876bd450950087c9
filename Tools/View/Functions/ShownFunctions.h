// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef tetmarch_ShownFunctions_h
#define tetmarch_ShownFunctions_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"

class vtkColorTransferFunction;
class vtkPiecewiseFunction;

namespace tetmarch
{

/**
 * The functions that the chart draws and edits: those of the volume over an axis from 0 to 1. VTK's
 * control points can't be hit, in VTK 9.1, where the values are large beside their range: 1000 to
 * 1001. Whatever changes on one side changes on the other; points that stay do so to the last bit.
 */
class ShownFunctions
{
public:
  ShownFunctions();
  ~ShownFunctions();

  void SetFunctions(vtkColorTransferFunction* color, vtkPiecewiseFunction* opacity);

  /// The values that are drawn at 0 and at 1.
  void SetAxis(double low, double high);
  double ToAxis(double value) const { return (value - this->Low) / (this->High - this->Low); }
  double FromAxis(double place) const { return this->Low + place * (this->High - this->Low); }

  vtkPiecewiseFunction* GetOpacity() { return this->ShownOpacity; }
  /// The colours' points, which are edited.
  vtkColorTransferFunction* GetColorPoints() { return this->ShownColor; }
  /// The colours as the volume has them, whatever lies between their points.
  vtkColorTransferFunction* GetColors() { return this->Samples; }

private:
  void Observe(bool on);
  void ShowAll();
  void ShowOpacity();
  void ShowColors();
  void TakeOpacity();
  void TakeColors();
  void SampleColors();

  double Low = 0.0;
  double High = 1.0;
  bool Busy = false; ///< one side follows the other
  vtkSmartPointer<vtkColorTransferFunction> Color;
  vtkSmartPointer<vtkPiecewiseFunction> Opacity;
  vtkNew<vtkColorTransferFunction> ShownColor;
  vtkNew<vtkPiecewiseFunction> ShownOpacity;
  vtkNew<vtkColorTransferFunction> Samples;
  unsigned long ColorObserver = 0;
  unsigned long OpacityObserver = 0;
};

} // namespace tetmarch

#endif
