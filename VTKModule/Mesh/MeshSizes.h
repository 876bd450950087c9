// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Sizes of the buffers of a mesh on the GPU.
#ifndef TetMarchMeshMeshSizes_h
#define TetMarchMeshMeshSizes_h

#include "Budget/ResourceLimits.h"

#include <cstdint>
#include <vector>

namespace tetmarch
{

struct TetMesh;

/** Maximum number of texture buffers for data with one texel per tetrahedron. */
constexpr std::uint64_t MostCellBuffers = 2;

/** Sizes of a mesh, its cell scalars (0 if point scalars are drawn) and words of hidden cells (0 if
 * there are none). */
std::vector<BufferSize> bufferSizes(
  const TetMesh& mesh, std::uint64_t cellScalars, std::uint64_t hiddenCellWords);

/** Lower bounds of the sizes for a number of tetrahedra. */
std::vector<BufferSize> leastBufferSizes(std::uint64_t tetrahedra);

/** Upper bound of the number of tetrahedra within the limits. */
std::uint64_t mostTetrahedra(const ResourceLimits& limits);

} // namespace tetmarch

#endif
