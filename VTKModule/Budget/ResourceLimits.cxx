// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Budget/ResourceLimits.h"

namespace tetmarch
{
namespace
{

std::string mostTexelsOf(const BufferSize& size, const ResourceLimits& limits)
{
  const std::string each = "GL_MAX_TEXTURE_BUFFER_SIZE";
  return std::to_string(size.MostBuffers * limits.TexelsPerBuffer) +
         (size.MostBuffers > 1 ? " (" + std::to_string(size.MostBuffers) + " x " + each + ")"
                               : " (" + each + ")");
}

} // namespace

std::string describeExcess(
  const std::vector<BufferSize>& sizes, const ResourceLimits& limits, SizesAre sizesAre)
{
  const std::string least = sizesAre == SizesAre::LowerBounds ? "at least " : "";
  std::uint64_t bytes = 0;
  for (const BufferSize& size : sizes)
  {
    bytes += size.Texels * size.BytesPerTexel;
    if ((size.Texels + size.MostBuffers - 1) / size.MostBuffers > limits.TexelsPerBuffer)
    {
      return "The mesh is too large for this GL: it needs " + least + std::to_string(size.Texels) +
             " texels for its " + size.Name + ", the GL takes " + mostTexelsOf(size, limits) +
             ". Extract or coarsen a part of the grid.";
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
