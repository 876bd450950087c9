// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FunctionPoints.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"

namespace tetmarch
{

void GetFunctions(
  vtkColorTransferFunction* color, vtkPiecewiseFunction* opacity, FunctionState& functions)
{
  functions.Color.resize(color->GetSize());
  for (int i = 0; i < color->GetSize(); ++i)
  {
    color->GetNodeValue(i, functions.Color[i].data());
  }
  functions.ColorSpace = color->GetColorSpace();
  functions.HSVWrap = color->GetHSVWrap() != 0;
  functions.LogScale = color->GetScale() == VTK_CTF_LOG10;
  const double* nan = color->GetNanColor();
  functions.NanColor = { { nan[0], nan[1], nan[2], color->GetNanOpacity() } };
  functions.Opacity.resize(opacity->GetSize());
  for (int i = 0; i < opacity->GetSize(); ++i)
  {
    opacity->GetNodeValue(i, functions.Opacity[i].data());
  }
}

void SetFunctions(
  const FunctionState& functions, vtkColorTransferFunction* color, vtkPiecewiseFunction* opacity)
{
  color->RemoveAllPoints();
  color->SetAllowDuplicateScalars(1);
  color->SetColorSpace(functions.ColorSpace);
  color->SetHSVWrap(functions.HSVWrap);
  functions.LogScale ? color->SetScaleToLog10() : color->SetScaleToLinear();
  for (const auto& p : functions.Color)
  {
    color->AddRGBPoint(p[0], p[1], p[2], p[3], p[4], p[5]);
  }
  const auto& nan = functions.NanColor;
  color->SetNanColorRGBA(nan[0], nan[1], nan[2], nan[3]);
  SetPoints(functions.Opacity, opacity);
}

void SetPoints(const std::vector<std::array<double, 4>>& points, vtkPiecewiseFunction* function)
{
  function->RemoveAllPoints();
  function->SetAllowDuplicateScalars(1);
  for (const auto& p : points)
  {
    function->AddPoint(p[0], p[1], p[2], p[3]);
  }
}

} // namespace tetmarch
