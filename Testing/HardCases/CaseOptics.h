// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Transfer functions for hard cases
 */
#ifndef tetmarch_testing_CaseOptics_h
#define tetmarch_testing_CaseOptics_h

#include "HardCase.h"

class vtkDataArray;

namespace tetmarch::testing
{
using OpticsSetter = std::function<void(vtkVolumeProperty*, vtkUnstructuredGrid*)>;

struct Range
{
  double Low;
  double High;
};
/// The range of the finite values. One value alone gets a range in which it lies where the standard
/// opacity is highest but for the end; without any the range is 0..1.
Range finiteRange(vtkDataArray* values);

/// The colours of setStandardOptics() over a range.
void setStandardColours(vtkVolumeProperty* property, const Range& range);
/// Its opacities over a range; the mean of them is about 0.28.
void setStandardOpacities(vtkVolumeProperty* property, const Range& range);
/// Opacity 1 all along the diagonal of the bounding box has that optical depth.
void setDepthOfDiagonal(vtkVolumeProperty* property, vtkUnstructuredGrid* grid, double depth);

/// The standard colours, opacities and unit distance over a range.
OpticsSetter standardOpticsOver(const Range& range);
/// The standard optics over the finite range of "c".
OpticsSetter standardOpticsOfCells();
/// Functions that every mapper integrates well, one ramp each of colour and opacity over the finite
/// range of "f", in place of those that the setter sets; its unit distance stays.
OpticsSetter withRamps(const OpticsSetter& setter);
} // namespace tetmarch::testing

#endif
