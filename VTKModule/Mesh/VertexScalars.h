// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Scalars of cells become scalars of vertices.
#ifndef TetMarchMeshVertexScalars_h
#define TetMarchMeshVertexScalars_h

#include "Mesh/VertexTets.h"

namespace tetmarch
{

/**
 * Scalars 0..1 at the vertices from one scalar a tetrahedron: at each vertex the value of the
 * linear function that fits those in the centres of the cells around it best (least squares by
 * inverse squared distance), or their mean by inverse distance where the centres lie in a plane. It
 * stays within their range. Of a linear field it is exact inside. Gradients made from it have 0.1
 * to 0.7 of the error of those made from plain means, near the sides of hexahedra about the same
 * (GradientErrorsTest).
 *
 * Only tetrahedra that take part (not 0) are used; a cell that was cut into several counts once.
 * UndrawnScalar at vertices about which none does.
 */
std::vector<float> vertexScalars(const TetMesh& mesh, const VertexTets& around,
  const std::vector<std::uint8_t>& takesPart, const std::vector<float>& cellScalars);

} // namespace tetmarch

#endif
