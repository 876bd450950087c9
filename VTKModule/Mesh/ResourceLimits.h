// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether a mesh fits the GPU, from sizes alone: before anything is allocated there.
#ifndef TetMarchMeshResourceLimits_h
#define TetMarchMeshResourceLimits_h

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace tetmarch
{

struct TetMesh;

struct ResourceLimits
{
  std::uint64_t TexelsPerBuffer = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t Bytes = 0; // of all buffers together; 0: no limit
};

struct BufferSize
{
  const char* Name; // plural
  std::uint64_t Texels;
  std::uint64_t BytesPerTexel;
};

/** Of a mesh, its cell scalars (0 if point scalars are drawn), words of hidden cells (0 if there
 * are none) and a table of so many entries. */
std::vector<BufferSize> bufferSizes(const TetMesh& mesh, std::uint64_t cellScalars,
  std::uint64_t hiddenCellWords, std::uint64_t tableEntries);

/** What so many tetrahedra need at least, whatever else. */
std::vector<BufferSize> leastBufferSizes(std::uint64_t tetrahedra);

/** How many tetrahedra such limits may hold; more certainly don't fit. */
std::uint64_t mostTetrahedra(const ResourceLimits& limits);

enum class SizesAre
{
  Exact,
  LowerBounds
};

/** Empty if the buffers fit; else a sentence with what is needed, what is allowed and what helps.
 */
std::string describeExcess(
  const std::vector<BufferSize>& sizes, const ResourceLimits& limits, SizesAre sizesAre);

} // namespace tetmarch

#endif
