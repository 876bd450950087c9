// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FunctionState.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <tuple>

namespace
{
auto Tie(const tetmarch::FunctionState& state)
{
  return std::tie(state.Colors, state.Opacities, state.IsoValues, state.NanColor, state.ColorSpace,
    state.Scale, state.HSVWrap, state.ColorDuplicates, state.OpacityDuplicates);
}
} // namespace

namespace tetmarch
{

bool FunctionState::operator==(const FunctionState& other) const
{
  return Tie(*this) == Tie(other);
}

FunctionState ReadState(vtkColorTransferFunction* color, vtkPiecewiseFunction* opacity)
{
  FunctionState state;
  state.Colors.resize(color->GetSize());
  for (int i = 0; i < color->GetSize(); ++i)
  {
    color->GetNodeValue(i, state.Colors[i].data());
  }
  state.Opacities.resize(opacity->GetSize());
  for (int i = 0; i < opacity->GetSize(); ++i)
  {
    opacity->GetNodeValue(i, state.Opacities[i].data());
  }
  std::copy_n(color->GetNanColor(), 3, state.NanColor.begin());
  state.ColorSpace = color->GetColorSpace();
  state.Scale = color->GetScale();
  state.HSVWrap = color->GetHSVWrap();
  state.ColorDuplicates = color->GetAllowDuplicateScalars();
  state.OpacityDuplicates = opacity->GetAllowDuplicateScalars();
  return state;
}

void WriteState(
  const FunctionState& state, vtkColorTransferFunction* color, vtkPiecewiseFunction* opacity)
{
  color->SetAllowDuplicateScalars(state.ColorDuplicates);
  color->SetColorSpace(state.ColorSpace);
  color->SetScale(state.Scale);
  color->SetHSVWrap(state.HSVWrap);
  color->SetNanColor(state.NanColor[0], state.NanColor[1], state.NanColor[2]);
  color->RemoveAllPoints();
  for (const auto& node : state.Colors)
  {
    color->AddRGBPoint(node[0], node[1], node[2], node[3], node[4], node[5]);
  }
  opacity->SetAllowDuplicateScalars(state.OpacityDuplicates);
  opacity->RemoveAllPoints();
  for (const auto& node : state.Opacities)
  {
    opacity->AddPoint(node[0], node[1], node[2], node[3]);
  }
}

} // namespace tetmarch
