// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/ResourceLimits.h"

#include "Mesh/TetMesh.h"

#include <algorithm>

namespace tetmarch
{

std::vector<BufferSize> bufferSizes(const TetMesh& mesh, std::uint64_t cellScalars,
  std::uint64_t hiddenCellWords, std::uint64_t tableEntries)
{
  return { { "links", mesh.Links.size(), sizeof(Link) },
    { "boundary faces", mesh.BoundaryFaces.size(), 16 },
    { "nodes of the hierarchy", 2 * mesh.Hierarchy.size(), sizeof(HierarchyNode) / 2 },
    { "vertices", mesh.Vertices.size(), sizeof(Vertex) },
    { "cell scalars", cellScalars, sizeof(float) },
    { "words of hidden cells", hiddenCellWords, sizeof(std::uint32_t) },
    { "table entries", tableEntries, 16 + 16 + 4 } };
}

std::vector<BufferSize> leastBufferSizes(std::uint64_t tetrahedra)
{
  return { { "links", 4 * tetrahedra, sizeof(Link) } };
}

std::uint64_t mostTetrahedra(const ResourceLimits& limits)
{
  const std::uint64_t byTexels = limits.TexelsPerBuffer / 4;
  return limits.Bytes > 0 ? std::min<std::uint64_t>(byTexels, limits.Bytes / (4 * sizeof(Link)))
                          : byTexels;
}

std::string describeExcess(
  const std::vector<BufferSize>& sizes, const ResourceLimits& limits, SizesAre sizesAre)
{
  const std::string least = sizesAre == SizesAre::LowerBounds ? "at least " : "";
  std::uint64_t bytes = 0;
  for (const BufferSize& size : sizes)
  {
    bytes += size.Texels * size.BytesPerTexel;
    if (size.Texels > limits.TexelsPerBuffer)
    {
      return "The mesh is too large for this GL: it needs " + least + std::to_string(size.Texels) +
             " texels for its " + size.Name + ", the GL takes " +
             std::to_string(limits.TexelsPerBuffer) +
             " (GL_MAX_TEXTURE_BUFFER_SIZE). Extract or coarsen a part of the grid.";
    }
  }
  if (limits.Bytes > 0 && bytes > limits.Bytes)
  {
    return "The mesh needs " + least + std::to_string(bytes) + " bytes on the GPU, allowed are " +
           std::to_string(limits.Bytes) +
           " (MaxMemoryInBytes). Raise that, or extract or coarsen a part of the grid.";
  }
  return {};
}

} // namespace tetmarch
