// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The mesh of a curvilinear grid, whose tetrahedra and links are computed from i, j, k.
#ifndef TetMarchMeshCurvilinearMesh_h
#define TetMarchMeshCurvilinearMesh_h

#include "Mesh/TetMeshBuilder.h"

#include "vtkSmartPointer.h"

class vtkStructuredGrid;

namespace tetmarch
{

/** Maximum number of hexahedra, so that all half-faces are below LinkOutside. */
constexpr std::uint64_t MostCurvilinearCells = MostTetsOfLinks / CurvilinearCells::TetsOfCell;

/**
 * Build the mesh of a valid grid (checkData) with cells along each axis. Without a stop or an error
 * the mesh is empty if such a grid needs stored cells: some tetrahedron is flat or turned inside
 * out, as in strongly warped hexahedra, or points of the boundary coincide. joinsSides: where a
 * ring closes and at poles they may (Mesh/JoinedSides.h).
 */
BuildStatus buildCurvilinearMesh(vtkStructuredGrid* grid, const Progress& progress, bool joinsSides,
  TetMesh& mesh, std::string& error);

/** The hexahedra of the grid. Cells and points keep their numbers. */
vtkSmartPointer<vtkUnstructuredGrid> hexahedraOf(vtkStructuredGrid* grid);

} // namespace tetmarch

#endif
