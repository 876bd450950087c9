// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Conversion of cell scalars to vertex scalars.
#ifndef TetMarchMeshVertexScalars_h
#define TetMarchMeshVertexScalars_h

#include "Mesh/VertexTets.h"

namespace tetmarch
{

class Group;

/**
 * Scalars 0..1 at the vertices from one scalar per tetrahedron. At each vertex it is the value of
 * the linear least-squares fit to the scalars in the centres of the surrounding cells (weighted by
 * the inverse squared distance), or, if the centres are coplanar, their mean weighted by inverse
 * distance. The value stays within their range. For a linear field it is exact inside the mesh.
 * Gradients of these scalars have 0.1 to 0.7 of the error of gradients of plain means, and about
 * the same near the sides of hexahedra (GradientErrorsTest).
 *
 * Only tetrahedra that take part (not 0) are used. A cell cut into several tetrahedra counts once.
 * Vertices without such tetrahedra get UndrawnScalar.
 *
 * With a group, whose processes have pieces of the mesh, it is collective: at shared vertices,
 * cells of all pieces count.
 */
std::vector<float> vertexScalars(const TetMesh& mesh, const VertexTets& around,
  const std::vector<std::uint8_t>& takesPart, const std::vector<float>& cellScalars,
  Group* group = nullptr);

} // namespace tetmarch

#endif
