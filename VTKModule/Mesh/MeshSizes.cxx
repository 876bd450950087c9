// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/MeshSizes.h"

#include "Mesh/PackedCells.h"

#include <algorithm>

namespace tetmarch
{

std::vector<BufferSize> bufferSizes(
  const TetMesh& mesh, std::uint64_t cellScalars, std::uint64_t hiddenCellWords)
{
  const bool computed = mesh.Curvilinear != nullptr;
  return { { "tetrahedra", computed ? 0 : mesh.Tets.size(), sizeof(PackedCell), MostCellBuffers },
    { "boundary faces", mesh.BoundaryFaces.size(), std::size_t(computed ? 20 : 16) },
    { "nodes of the hierarchy", 2 * mesh.Hierarchy.size(), sizeof(HierarchyNode) / 2 },
    { "vertices", mesh.Vertices.size(), sizeof(Vertex) },
    { "cell scalars", cellScalars, sizeof(float), MostCellBuffers },
    { "words of hidden cells", hiddenCellWords, sizeof(std::uint32_t) } };
}

std::vector<BufferSize> leastBufferSizes(std::uint64_t tetrahedra)
{
  return { { "tetrahedra", tetrahedra, sizeof(PackedCell), MostCellBuffers } };
}

std::uint64_t mostTetrahedra(const ResourceLimits& limits)
{
  const std::uint64_t most =
    std::min(MostCellBuffers * std::min(limits.TexelsPerBuffer, MostTetsOfLinks), MostTetsOfLinks);
  return limits.Bytes > 0 ? std::min<std::uint64_t>(most, limits.Bytes / sizeof(PackedCell)) : most;
}

} // namespace tetmarch
