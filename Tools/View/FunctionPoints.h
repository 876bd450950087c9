// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Transfer functions of a property as lists of points, and back.
 */
#ifndef tetmarch_FunctionPoints_h
#define tetmarch_FunctionPoints_h

#include "ViewState.h"

class vtkColorTransferFunction;
class vtkPiecewiseFunction;

namespace tetmarch
{

/// Colours, their space, scale and NaN colour, and opacities; leaves the rest of the state alone.
void GetFunctions(
  vtkColorTransferFunction* color, vtkPiecewiseFunction* opacity, FunctionState& functions);
void SetFunctions(
  const FunctionState& functions, vtkColorTransferFunction* color, vtkPiecewiseFunction* opacity);

void SetPoints(const std::vector<std::array<double, 4>>& points, vtkPiecewiseFunction* function);

} // namespace tetmarch

#endif
