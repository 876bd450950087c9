// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The edges of the boundary, and sets of boundary faces connected by them.
#ifndef TetMarchMeshBoundaryEdges_h
#define TetMarchMeshBoundaryEdges_h

#include "Mesh/TetMesh.h"

#include <vector>

namespace tetmarch
{

/** An edge of a boundary face. */
struct BoundaryEdge
{
  std::uint64_t Key; // smaller vertex, then larger
  Id Face;
  Id Opposite;  // the face's third vertex
  bool Forward; // the face traverses it from the smaller vertex to the larger
};

/** All edges of all boundary faces, sorted by key and face. */
std::vector<BoundaryEdge> sortedBoundaryEdges(const TetMesh& mesh);

/** The relation of edges[i] and edges[i + 1]. */
enum class EdgePair
{
  None,    // not the common edge of exactly two faces
  Regular, // the faces traverse it in opposite directions, as on every orientable surface
  Folded   // the faces traverse it in the same direction: an inverted tetrahedron overlaps its
           // neighbour
};
EdgePair pairOf(const std::vector<BoundaryEdge>& edges, std::size_t i);

/** Disjoint sets of faces (Galler and Fischer 1964). */
class FaceSets
{
public:
  explicit FaceSets(std::size_t faces);
  void join(Id a, Id b);
  Id rootOf(Id face);

private:
  std::vector<Id> Parent;
};

} // namespace tetmarch

#endif
