// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedra around each vertex.
#ifndef TetMarchMeshVertexTets_h
#define TetMarchMeshVertexTets_h

#include "Mesh/TetMesh.h"

namespace tetmarch
{

/** The tetrahedra of vertex v are Tets[Starts[v]] to Tets[Starts[v + 1] - 1], ascending. */
struct VertexTets
{
  std::vector<Id> Starts;
  std::vector<Id> Tets;

  explicit VertexTets(const TetMesh& mesh);

  const Id* begin(Id vertex) const { return this->Tets.data() + this->Starts[vertex]; }
  const Id* end(Id vertex) const { return this->Tets.data() + this->Starts[vertex + 1]; }
};

} // namespace tetmarch

#endif
