// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What the driver's compiler says of a fragment shader
 */
#ifndef tetmarch_gpu_Compilation_h
#define tetmarch_gpu_Compilation_h

#include "Device.h"
#include "SpirvInterface.h"

#include <cstdint>
#include <map>
#include <string>

namespace tetmarch::gpu
{
struct Compilation
{
  std::uint32_t SubgroupSize = 0;
  std::map<std::string, double> Statistics; // by the names that the driver has for them
};

/// Makes a graphics pipeline that draws all outputs of the fragment shader into targets of 32-bit
/// floats; the vertex shader has no uniforms. Throws std::runtime_error.
Compilation compile(const Device& device, const SpirvWords& vertex, const SpirvWords& fragment);
} // namespace tetmarch::gpu

#endif
