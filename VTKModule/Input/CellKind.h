// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Decomposition and number of points of each of VTK's cell types.
#ifndef TetMarchInputCellKind_h
#define TetMarchInputCellKind_h

#include "vtkType.h"

#include <array>

namespace tetmarch
{

enum class CellCut
{
  Unknown,        // no type of VTK
  Empty,          // VTK_EMPTY_CELL: skipped
  LowDimensional, // vertices, lines, surfaces: skipped and counted
  Unsupported,    // 3D, but VTK can't triangulate it: skipped and counted
  Tetrahedron,    // used unchanged
  Pieces,         // by cellPieces()
  Polyhedron,     // by its stream of faces
  ByVTK           // by linearParts() if it has these, or by vtkCell::Triangulate
};

struct CellKind
{
  CellCut Cut = CellCut::Unknown;
  vtkIdType LeastPoints = 0; // of cells that aren't skipped
  vtkIdType MostPoints = VTK_ID_MAX;
};

/** Indexed by the value of the cell types array. */
const std::array<CellKind, 256>& cellKinds();

} // namespace tetmarch

#endif
