// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a mesh needs on the GPU.
#ifndef TetMarchMeshMeshSizes_h
#define TetMarchMeshMeshSizes_h

#include "Budget/ResourceLimits.h"

#include <cstdint>
#include <vector>

namespace tetmarch
{

struct TetMesh;

/** What has a texel for each tetrahedron may lie in so many texture buffers. */
constexpr std::uint64_t MostCellBuffers = 2;

/** Of a mesh, its cell scalars (0 if point scalars are drawn) and words of hidden cells (0 if there
 * are none). */
std::vector<BufferSize> bufferSizes(
  const TetMesh& mesh, std::uint64_t cellScalars, std::uint64_t hiddenCellWords);

/** What so many tetrahedra need at least, whatever else. */
std::vector<BufferSize> leastBufferSizes(std::uint64_t tetrahedra);

/** How many tetrahedra such limits may hold; more certainly don't fit. */
std::uint64_t mostTetrahedra(const ResourceLimits& limits);

} // namespace tetmarch

#endif
