// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * All that the editor changes, as plain numbers: what undo goes back to, and what tells whether
 * anything has changed.
 */
#ifndef tetmarch_FunctionSnapshot_h
#define tetmarch_FunctionSnapshot_h

#include <array>
#include <vector>

class vtkColorTransferFunction;
class vtkPiecewiseFunction;

namespace tetmarch
{

struct FunctionSnapshot
{
  using ColorNode = std::array<double, 6>;   ///< value, red, green, blue, midpoint, sharpness
  using OpacityNode = std::array<double, 4>; ///< value, opacity, midpoint, sharpness

  std::vector<ColorNode> Colors;
  std::vector<OpacityNode> Opacities;
  std::vector<double> IsoValues;
  std::array<double, 3> NanColor = {};
  int ColorSpace = 0;
  int Scale = 0;
  int HSVWrap = 0;
  int ColorDuplicates = 0; ///< whether several colour points may have the same value
  int OpacityDuplicates = 0;

  bool operator==(const FunctionSnapshot& other) const;
  bool operator!=(const FunctionSnapshot& other) const { return !(*this == other); }
};

/// IsoValues are left empty: they are in neither function.
FunctionSnapshot TakeSnapshot(vtkColorTransferFunction* color, vtkPiecewiseFunction* opacity);

/// Makes the functions what they were when the state was read.
void ApplySnapshot(
  const FunctionSnapshot& state, vtkColorTransferFunction* color, vtkPiecewiseFunction* opacity);

} // namespace tetmarch

#endif
