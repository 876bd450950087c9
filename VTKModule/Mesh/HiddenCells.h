// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells that a grid's ghost arrays keep from being drawn.
#ifndef TetMarchMeshHiddenCells_h
#define TetMarchMeshHiddenCells_h

#include "Mesh/TetMesh.h"

class vtkUnsignedCharArray;
class vtkUnstructuredGrid;

namespace tetmarch
{

/** A bit a tetrahedron: bit t % 32 of word t / 32. Empty if none is hidden. */
using HiddenCells = std::vector<std::uint32_t>;

/** vtkGhostType of cells and of points; nullptr if there is none, or one that isn't of unsigned
 * char, or hasn't one value for each. */
struct GhostArrays
{
  vtkUnsignedCharArray* OfCells = nullptr;
  vtkUnsignedCharArray* OfPoints = nullptr;
};
GhostArrays ghostArraysOf(vtkUnstructuredGrid* grid);

/**
 * Hidden are tetrahedra of cells that are hidden themselves, that lie on another process as well
 * (duplicates, which that one draws) or that finer ones refine; and of cells with a hidden point.
 */
HiddenCells hiddenCells(vtkUnstructuredGrid* grid, const TetMesh& mesh);

} // namespace tetmarch

#endif
