// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FunctionSnapshot.h"

#include "FunctionNodes.h"

#include <algorithm>
#include <tuple>

namespace
{
auto Tie(const tetmarch::FunctionSnapshot& state)
{
  return std::tie(state.Colors, state.Opacities, state.IsoValues, state.NanColor, state.ColorSpace,
    state.Scale, state.HSVWrap, state.ColorDuplicates, state.OpacityDuplicates);
}
} // namespace

namespace tetmarch
{

bool FunctionSnapshot::operator==(const FunctionSnapshot& other) const
{
  return Tie(*this) == Tie(other);
}

FunctionSnapshot TakeSnapshot(vtkColorTransferFunction* color, vtkPiecewiseFunction* opacity)
{
  FunctionSnapshot state;
  state.Colors = GetNodes(color);
  state.Opacities = GetNodes(opacity);
  std::copy_n(color->GetNanColor(), 3, state.NanColor.begin());
  state.ColorSpace = color->GetColorSpace();
  state.Scale = color->GetScale();
  state.HSVWrap = color->GetHSVWrap();
  state.ColorDuplicates = color->GetAllowDuplicateScalars();
  state.OpacityDuplicates = opacity->GetAllowDuplicateScalars();
  return state;
}

void ApplySnapshot(
  const FunctionSnapshot& state, vtkColorTransferFunction* color, vtkPiecewiseFunction* opacity)
{
  color->SetAllowDuplicateScalars(state.ColorDuplicates);
  color->SetColorSpace(state.ColorSpace);
  color->SetScale(state.Scale);
  color->SetHSVWrap(state.HSVWrap);
  color->SetNanColor(state.NanColor[0], state.NanColor[1], state.NanColor[2]);
  SetNodes(color, state.Colors);
  opacity->SetAllowDuplicateScalars(state.OpacityDuplicates);
  SetNodes(opacity, state.Opacities);
}

} // namespace tetmarch
