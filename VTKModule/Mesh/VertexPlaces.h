// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The positions of vertices that are points of the grid.
#ifndef TetMarchMeshVertexPlaces_h
#define TetMarchMeshVertexPlaces_h

#include "Mesh/TetMesh.h"

#include <string>

class vtkPoints;

namespace tetmarch
{

/** The point of each vertex (TetMesh::VertexPoints), none of which is the centre of a cell. */
std::vector<Vector3> positionsOf(vtkPoints* points, const TetMesh& mesh);

/** Set the frame of the positions, and the vertices in it; their scalars are 0. Returns an empty
 * string, or an error. */
std::string placeVertices(const std::vector<Vector3>& positions, TetMesh& mesh);

} // namespace tetmarch

#endif
