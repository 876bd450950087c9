// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Vertices and tetrahedra in an order in which neighbours in space are neighbours in memory.
#ifndef TetMarchMeshRenumbering_h
#define TetMarchMeshRenumbering_h

#include "Mesh/Decomposition.h"
#include "Mesh/TetMesh.h"

#include <string>

class vtkPoints;

namespace tetmarch
{

/**
 * Fill Vertices (scalars 0), VertexPoints, Center, Radius, Tets and TetCells of the mesh: points
 * that no tetrahedron uses are left out, the rest is ordered along the Morton curve (Morton 1966),
 * tetrahedra by their smallest vertex; tetrahedra with a repeated point are dropped and counted.
 * Positions are centred and scaled in double precision before they are rounded to float.
 *
 * Returns an empty string, or what is wrong with the points.
 */
std::string renumber(
  vtkPoints* points, Decomposition&& tets, const Progress& progress, TetMesh& mesh, bool& stopped);

} // namespace tetmarch

#endif
