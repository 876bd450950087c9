// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What a SPIR-V module reads and writes: as much as a pipeline must be told
 */
#ifndef tetmarch_gpu_SpirvInterface_h
#define tetmarch_gpu_SpirvInterface_h

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <vulkan/vulkan_core.h>

namespace tetmarch::gpu
{
using SpirvWords = std::vector<std::uint32_t>;

/// Throws std::runtime_error if the file is none of SPIR-V.
SpirvWords readSpirv(const std::string& file);

struct SpirvBinding
{
  VkDescriptorType Type;
  std::uint32_t Count;
};

struct SpirvInterface
{
  std::map<std::uint32_t, SpirvBinding> Bindings; // of descriptor set 0, where glslang puts all
  std::uint32_t Outputs = 0;                      // locations
};

/// Of a module that glslang made of GLSL; throws std::runtime_error for a kind of binding that our
/// shaders have not.
SpirvInterface interfaceOf(const SpirvWords& module);
} // namespace tetmarch::gpu

#endif
