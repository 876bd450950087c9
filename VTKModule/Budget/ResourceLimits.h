// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether buffers fit the GPU, by their sizes: before anything is allocated there.
#ifndef TetMarchBudgetResourceLimits_h
#define TetMarchBudgetResourceLimits_h

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace tetmarch
{

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
  std::uint64_t MostBuffers = 1; // that the texels may be in
};

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
