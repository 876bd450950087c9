// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Other values and other types for the scalars of a grid
 *
 * The argument is never changed.
 */
#ifndef tetmarch_testing_CaseScalars_h
#define tetmarch_testing_CaseScalars_h

#include "GridBuilder.h"

#include "vtkSmartPointer.h"

#include <cstdint>
#include <functional>

class vtkDataArray;

namespace tetmarch::testing
{
/// The new value of tuple i.
using ValueMap = std::function<double(double value, vtkIdType i)>;

/// "f" with other values (double).
Grid withPointValues(vtkUnstructuredGrid* grid, const ValueMap& map);
/// "c" with other values (double).
Grid withCellValues(vtkUnstructuredGrid* grid, const ValueMap& map);

/// The values spread over all that an integer type (VTK_SHORT, ...) holds, its lowest and its
/// highest value included; 0 and 1 for VTK_BIT.
vtkSmartPointer<vtkDataArray> overWholeType(vtkDataArray* values, int vtkType);
/// The values spread over low + 0 ... low + width, which doubles may be too coarse for.
vtkSmartPointer<vtkDataArray> asSigned64(
  vtkDataArray* values, std::int64_t low, std::uint64_t width);
vtkSmartPointer<vtkDataArray> asUnsigned64(
  vtkDataArray* values, std::uint64_t low, std::uint64_t width);

/// "f" (or "c") by a function of the array that the grid has.
using ArrayMap = std::function<vtkSmartPointer<vtkDataArray>(vtkDataArray*)>;
Grid withPointArray(vtkUnstructuredGrid* grid, const ArrayMap& map);
Grid withCellArray(vtkUnstructuredGrid* grid, const ArrayMap& map);
} // namespace tetmarch::testing

#endif
