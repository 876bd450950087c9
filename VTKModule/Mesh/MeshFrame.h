// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The frame of a mesh, in which its vertices are floats.
#ifndef TetMarchMeshMeshFrame_h
#define TetMarchMeshMeshFrame_h

#include "Mesh/TetMesh.h"

#include <string>

namespace tetmarch
{

using Position = std::array<double, 3>;

/** Set Center, Radius and HalfExtent by the box of these positions. Returns an empty string, or
 * what is wrong with them. */
std::string findFrame(const std::vector<Position>& positions, TetMesh& mesh);

/** Centred and scaled in double precision before it is rounded to float; the scalar is 0. */
Vertex vertexAt(const Position& position, const TetMesh& mesh);

} // namespace tetmarch

#endif
