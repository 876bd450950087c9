// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief An unstructured grid as the arrays it is made of, whether they fit together or not
 */
#ifndef tetmarch_testing_RawGrid_h
#define tetmarch_testing_RawGrid_h

#include "GridBuilder.h"
#include "RawFaces.h"

namespace tetmarch::testing
{
struct RawGrid
{
  std::vector<double> Points; // three a point
  std::vector<unsigned char> Types;
  Ids Offsets;
  Ids Connectivity;
  RawFaces Faces; // of polyhedra
  bool HasFaces = false;
  bool Wide = true; // 64 bits for offsets and connectivity, not 32
  bool FloatPoints = false;

  RawGrid() = default;
  /// The arrays of a sound grid.
  explicit RawGrid(vtkUnstructuredGrid* grid);

  /// A grid of just these arrays; nothing is checked, nothing is allocated beyond them.
  Grid grid() const;
};
} // namespace tetmarch::testing

#endif
