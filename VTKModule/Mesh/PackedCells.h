// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Tetrahedra in 16 bytes, as the march reads them (Aman, Demirci and Gudukbay, "Compact
// tetrahedralization-based acceleration structures for ray tracing", 2021): a ray that enters
// through a known face needs only differences.
#ifndef TetMarchMeshPackedCells_h
#define TetMarchMeshPackedCells_h

#include "Mesh/TetMesh.h"

namespace tetmarch
{

/** The exclusive or of the four vertices; then, for faces 0, 1 and 2, that of the face's link and
 * the link of face 3. Shaders/tet/packed_cells.glsl decodes it. */
using PackedCell = std::array<Id, 4>;

inline PackedCell packedCell(const TetMesh& mesh, std::size_t tet)
{
  const auto& v = mesh.Tets[tet];
  const Id last = mesh.Links[4 * tet + 3];
  return { { v[0] ^ v[1] ^ v[2] ^ v[3], mesh.Links[4 * tet] ^ last, mesh.Links[4 * tet + 1] ^ last,
    mesh.Links[4 * tet + 2] ^ last } };
}

/** Fill the vector with the tetrahedra from begin to end, in parallel. */
void packCells(
  const TetMesh& mesh, std::size_t begin, std::size_t end, std::vector<PackedCell>& cells);

} // namespace tetmarch

#endif
