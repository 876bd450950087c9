// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Checks before any allocation whether buffers fit on the GPU.
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
  std::uint64_t MostBuffers = 1; // maximum number of buffers for the texels
};

enum class SizesAre
{
  Exact,
  LowerBounds
};

/** Empty if the buffers fit; else a sentence with the required and allowed sizes and a remedy.
 */
std::string describeExcess(
  const std::vector<BufferSize>& sizes, const ResourceLimits& limits, SizesAre sizesAre);

} // namespace tetmarch

#endif
