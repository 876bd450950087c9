// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which byte stands for which type of cell: an index into a list, or VTK's number plus 128
 */
#ifndef tetmarch_testing_CellTypeCode_h
#define tetmarch_testing_CellTypeCode_h

#include "vtkCellType.h"

#include <algorithm>
#include <iterator>

namespace tetmarch::testing
{
constexpr int CellTypes[] = { VTK_TETRA, VTK_VOXEL, VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID,
  VTK_PENTAGONAL_PRISM, VTK_HEXAGONAL_PRISM, VTK_POLYHEDRON, VTK_CONVEX_POINT_SET,
  VTK_QUADRATIC_TETRA, VTK_QUADRATIC_HEXAHEDRON, VTK_QUADRATIC_WEDGE, VTK_QUADRATIC_PYRAMID,
  VTK_TRIQUADRATIC_HEXAHEDRON, VTK_TRIQUADRATIC_PYRAMID, VTK_QUADRATIC_LINEAR_WEDGE,
  VTK_BIQUADRATIC_QUADRATIC_WEDGE, VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, VTK_LAGRANGE_TETRAHEDRON,
  VTK_LAGRANGE_HEXAHEDRON, VTK_LAGRANGE_WEDGE, VTK_BEZIER_TETRAHEDRON, VTK_BEZIER_HEXAHEDRON,
  VTK_BEZIER_WEDGE };
constexpr int CountOfTypes = static_cast<int>(std::size(CellTypes));

/// Of a byte.
inline int typeOfCode(int code) { return code < 128 ? CellTypes[code % CountOfTypes] : code - 128; }

inline int codeOfType(int type)
{
  const int* found = std::find(std::begin(CellTypes), std::end(CellTypes), type);
  return found == std::end(CellTypes) ? 128 + type : static_cast<int>(found - CellTypes);
}
} // namespace tetmarch::testing

#endif
