// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A Vulkan device that compiles pipelines and tells what became of them
 */
#ifndef tetmarch_gpu_Device_h
#define tetmarch_gpu_Device_h

#include <string>

#include <vulkan/vulkan_core.h>

namespace tetmarch::gpu
{
/// Throws std::runtime_error if the result is none of success.
void check(VkResult result, const char* what);

/// The first device that the loader has: RADV_FORCE_FAMILY and VK_ICD_FILENAMES choose it.
class Device
{
public:
  Device();
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  VkDevice handle() const { return this->Handle; }

  /// A function of an extension.
  template <typename Function>
  Function get(const char* name) const
  {
    return reinterpret_cast<Function>(this->find(name));
  }

  std::string Name;   // such as "AMD Radeon RX 6800 (RADV NAVI21)"
  std::string Driver; // such as "radv Mesa 22.3.6"

private:
  PFN_vkVoidFunction find(const char* name) const;

  VkInstance Instance = VK_NULL_HANDLE;
  VkDevice Handle = VK_NULL_HANDLE;
};
} // namespace tetmarch::gpu

#endif
