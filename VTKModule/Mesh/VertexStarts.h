// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The starting tetrahedra of rays from vertices.
#ifndef TetMarchMeshVertexStarts_h
#define TetMarchMeshVertexStarts_h

#include "Mesh/TetMesh.h"

namespace tetmarch
{

/** The tetrahedron of a vertex without one. */
constexpr Id NoTet = 0xffffffffu;

/**
 * For each vertex v a tetrahedron around it, two other vertices and the link of its face 3: {x, y,
 * link, tet}. With a = v, b = x, c = y and d the fourth vertex the faces (a, b, c), (a, d, b), (b,
 * d, c) and (c, d, a) turn counter-clockwise seen from outside of the tetrahedron, as
 * outsideSigns() says. Of the tetrahedra around the vertex it is the one with the largest inscribed
 * sphere (the first of equals), which minimizes the effect of rounding of the ray. {0, 0, 0, NoTet}
 * for a vertex without tetrahedra.
 */
std::vector<std::array<Id, 4>> vertexStarts(const TetMesh& mesh);

/** Vertex d. */
inline Id fourthVertex(const TetMesh& mesh, Id vertex, const std::array<Id, 4>& start)
{
  const auto& tet = mesh.Tets[start[3]];
  return tet[0] ^ tet[1] ^ tet[2] ^ tet[3] ^ vertex ^ start[0] ^ start[1];
}

/**
 * The starting point of rays from a vertex, slightly inside the tetrahedron. It is computed as in
 * Shaders/light/vertex_light.glsl, so that a vertex on a surface is on the same side as in the
 * march. False if the vertex has no tetrahedron.
 */
bool startPoint(
  const TetMesh& mesh, std::size_t vertex, const std::array<Id, 4>& start, Vector3& point);

} // namespace tetmarch

#endif
