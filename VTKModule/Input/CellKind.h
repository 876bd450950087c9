// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// How cells of each of VTK's types are cut, and how many points they must have.
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
  Unsupported,    // 3D, but VTK itself can't cut it: skipped and counted
  Tetrahedron,    // taken as it is
  Pieces,         // by cellPieces()
  Polyhedron,     // by its stream of faces
  ByVTK           // by vtkCell::Triangulate
};

struct CellKind
{
  CellCut Cut = CellCut::Unknown;
  vtkIdType LeastPoints = 0; // of cells that aren't skipped
  vtkIdType MostPoints = VTK_ID_MAX;
};

/** By the value of the array of cell types. */
const std::array<CellKind, 256>& cellKinds();

} // namespace tetmarch

#endif
