// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A Vulkan object that goes with its scope
 */
#ifndef tetmarch_gpu_Owned_h
#define tetmarch_gpu_Owned_h

#include "Device.h"

namespace tetmarch::gpu
{
template <typename Handle, void (*Destroy)(VkDevice, Handle, const VkAllocationCallbacks*)>
class Owned
{
public:
  /// create is such as vkCreateShaderModule.
  template <typename Create, typename Info>
  Owned(const Device& device, Create create, const Info& info, const char* what)
    : Of(device.handle())
  {
    check(create(this->Of, &info, nullptr, &this->Object), what);
  }
  ~Owned() { Destroy(this->Of, this->Object, nullptr); }
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;

  Handle operator*() const { return this->Object; }

private:
  VkDevice Of;
  Handle Object = VK_NULL_HANDLE;
};

using OwnedModule = Owned<VkShaderModule, vkDestroyShaderModule>;
using OwnedSetLayout = Owned<VkDescriptorSetLayout, vkDestroyDescriptorSetLayout>;
using OwnedLayout = Owned<VkPipelineLayout, vkDestroyPipelineLayout>;
using OwnedRenderPass = Owned<VkRenderPass, vkDestroyRenderPass>;
using OwnedPipeline = Owned<VkPipeline, vkDestroyPipeline>;
} // namespace tetmarch::gpu

#endif
