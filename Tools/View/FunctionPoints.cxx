// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FunctionPoints.h"

#include "FunctionNodes.h"

namespace tetmarch
{

void GetFunctions(
  vtkColorTransferFunction* color, vtkPiecewiseFunction* opacity, FunctionState& functions)
{
  functions.Color = GetNodes(color);
  functions.ColorSpace = color->GetColorSpace();
  functions.HSVWrap = color->GetHSVWrap() != 0;
  functions.LogScale = color->GetScale() == VTK_CTF_LOG10;
  const double* nan = color->GetNanColor();
  functions.NanColor = { { nan[0], nan[1], nan[2], color->GetNanOpacity() } };
  functions.Opacity = GetNodes(opacity);
}

void SetFunctions(
  const FunctionState& functions, vtkColorTransferFunction* color, vtkPiecewiseFunction* opacity)
{
  color->SetAllowDuplicateScalars(1);
  color->SetColorSpace(functions.ColorSpace);
  color->SetHSVWrap(functions.HSVWrap);
  functions.LogScale ? color->SetScaleToLog10() : color->SetScaleToLinear();
  SetNodes(color, functions.Color);
  const auto& nan = functions.NanColor;
  color->SetNanColorRGBA(nan[0], nan[1], nan[2], nan[3]);
  SetPoints(functions.Opacity, opacity);
}

void SetPoints(const std::vector<std::array<double, 4>>& points, vtkPiecewiseFunction* function)
{
  function->SetAllowDuplicateScalars(1);
  SetNodes(function, points);
}

} // namespace tetmarch
