// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Orders vertices and tetrahedra such that neighbours in space are neighbours in memory.
#ifndef TetMarchMeshRenumbering_h
#define TetMarchMeshRenumbering_h

#include "Mesh/Decomposition.h"
#include "Mesh/PieceOptions.h"
#include "Mesh/TetMesh.h"

#include <string>

class vtkPoints;

namespace tetmarch
{

/**
 * Fill Vertices (with scalars 0), VertexPoints, Frame, Tets and TetCells of the mesh. Unused points
 * are left out; the others are ordered along the Morton curve (Morton 1966), and tetrahedra by
 * their smallest vertex. Tetrahedra with a repeated point are dropped and counted.
 *
 * Returns an empty string, or the error of the points.
 */
std::string renumber(vtkPoints* points, Decomposition&& tets, const Progress& progress,
  TetMesh& mesh, bool& stopped, const PieceOptions& piece = {});

} // namespace tetmarch

#endif
