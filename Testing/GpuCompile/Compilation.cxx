// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Compilation.h"

#include "Owned.h"

#include <stdexcept>
#include <vector>

namespace tetmarch::gpu
{
namespace
{
VkShaderModuleCreateInfo moduleInfo(const SpirvWords& words)
{
  VkShaderModuleCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
  info.codeSize = words.size() * sizeof(std::uint32_t);
  info.pCode = words.data();
  return info;
}

VkPipelineShaderStageCreateInfo stageInfo(VkShaderStageFlagBits stage, VkShaderModule module)
{
  VkPipelineShaderStageCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
  info.stage = stage;
  info.module = module;
  info.pName = "main";
  return info;
}

std::vector<VkDescriptorSetLayoutBinding> bindingsOf(const SpirvInterface& interface)
{
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  for (const auto& [number, binding] : interface.Bindings)
  {
    bindings.push_back(
      { number, binding.Type, binding.Count, VK_SHADER_STAGE_FRAGMENT_BIT, nullptr });
  }
  return bindings;
}

VkDescriptorSetLayoutCreateInfo setInfo(const std::vector<VkDescriptorSetLayoutBinding>& bindings)
{
  VkDescriptorSetLayoutCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
  info.bindingCount = static_cast<std::uint32_t>(bindings.size());
  info.pBindings = bindings.data();
  return info;
}

VkPipelineLayoutCreateInfo layoutInfo(const VkDescriptorSetLayout& set)
{
  VkPipelineLayoutCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
  info.setLayoutCount = 1;
  info.pSetLayouts = &set;
  return info;
}

/// What is drawn into: an output without a target would be left out, with all that leads to it.
struct Targets
{
  explicit Targets(std::uint32_t colors)
  {
    for (std::uint32_t i = 0; i <= colors; ++i)
    {
      const bool depth = i == colors;
      VkAttachmentDescription target{};
      target.format = depth ? VK_FORMAT_D32_SFLOAT : VK_FORMAT_R32G32B32A32_SFLOAT;
      target.samples = VK_SAMPLE_COUNT_1_BIT;
      target.finalLayout = VK_IMAGE_LAYOUT_GENERAL;
      this->All.push_back(target);
      this->References.push_back({ i, VK_IMAGE_LAYOUT_GENERAL });
    }
    this->Subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    this->Subpass.colorAttachmentCount = colors;
    this->Subpass.pColorAttachments = this->References.data();
    this->Subpass.pDepthStencilAttachment = &this->References.back();
  }

  VkRenderPassCreateInfo info() const
  {
    VkRenderPassCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO;
    info.attachmentCount = static_cast<std::uint32_t>(this->All.size());
    info.pAttachments = this->All.data();
    info.subpassCount = 1;
    info.pSubpasses = &this->Subpass;
    return info;
  }

private:
  std::vector<VkAttachmentDescription> All;
  std::vector<VkAttachmentReference> References;
  VkSubpassDescription Subpass{};
};

/// The state of a pass that draws triangles over the whole target, as ours do.
struct State
{
  explicit State(std::uint32_t colors)
    : Blends(colors)
  {
    this->Input.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
    this->Assembly.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
    this->Assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    this->Viewports.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
    this->Viewports.viewportCount = 1;
    this->Viewports.pViewports = &this->Area;
    this->Viewports.scissorCount = 1;
    this->Viewports.pScissors = &this->Scissor;
    this->Raster.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
    this->Raster.lineWidth = 1.0f;
    this->Samples.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
    this->Samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
    this->Depth.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO;
    this->Depth.depthTestEnable = VK_TRUE;
    this->Depth.depthWriteEnable = VK_TRUE;
    this->Depth.depthCompareOp = VK_COMPARE_OP_LESS;
    for (VkPipelineColorBlendAttachmentState& blend : this->Blends)
    {
      blend.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT |
                             VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
    }
    this->Blend.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
    this->Blend.attachmentCount = colors;
    this->Blend.pAttachments = this->Blends.data();
  }

  VkGraphicsPipelineCreateInfo info() const
  {
    VkGraphicsPipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO;
    info.flags = VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR;
    info.pVertexInputState = &this->Input;
    info.pInputAssemblyState = &this->Assembly;
    info.pViewportState = &this->Viewports;
    info.pRasterizationState = &this->Raster;
    info.pMultisampleState = &this->Samples;
    info.pDepthStencilState = &this->Depth;
    info.pColorBlendState = &this->Blend;
    return info;
  }

private:
  VkViewport Area{ 0.0f, 0.0f, 512.0f, 512.0f, 0.0f, 1.0f };
  VkRect2D Scissor{ { 0, 0 }, { 512, 512 } };
  std::vector<VkPipelineColorBlendAttachmentState> Blends;
  VkPipelineVertexInputStateCreateInfo Input{};
  VkPipelineInputAssemblyStateCreateInfo Assembly{};
  VkPipelineViewportStateCreateInfo Viewports{};
  VkPipelineRasterizationStateCreateInfo Raster{};
  VkPipelineMultisampleStateCreateInfo Samples{};
  VkPipelineDepthStencilStateCreateInfo Depth{};
  VkPipelineColorBlendStateCreateInfo Blend{};
};

VkResult createPipeline(VkDevice device, const VkGraphicsPipelineCreateInfo* info,
  const VkAllocationCallbacks* allocation, VkPipeline* pipeline)
{
  return vkCreateGraphicsPipelines(device, VK_NULL_HANDLE, 1, info, allocation, pipeline);
}

double numberOf(const VkPipelineExecutableStatisticKHR& statistic)
{
  switch (statistic.format)
  {
    case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_BOOL32_KHR:
      return statistic.value.b32 ? 1.0 : 0.0;
    case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_INT64_KHR:
      return static_cast<double>(statistic.value.i64);
    case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_UINT64_KHR:
      return static_cast<double>(statistic.value.u64);
    default:
      return statistic.value.f64;
  }
}

/// What the driver says of the executable that the fragment shader became.
Compilation statisticsOf(const Device& device, VkPipeline pipeline)
{
  VkPipelineInfoKHR of{};
  of.sType = VK_STRUCTURE_TYPE_PIPELINE_INFO_KHR;
  of.pipeline = pipeline;
  const auto properties =
    device.get<PFN_vkGetPipelineExecutablePropertiesKHR>("vkGetPipelineExecutablePropertiesKHR");
  const auto statistics =
    device.get<PFN_vkGetPipelineExecutableStatisticsKHR>("vkGetPipelineExecutableStatisticsKHR");
  std::uint32_t count = 0;
  check(properties(device.handle(), &of, &count, nullptr), "no executables");
  VkPipelineExecutablePropertiesKHR noExecutable{};
  noExecutable.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_PROPERTIES_KHR;
  std::vector<VkPipelineExecutablePropertiesKHR> executables(count, noExecutable);
  check(properties(device.handle(), &of, &count, executables.data()), "no executables");
  for (std::uint32_t index = 0; index < count; ++index)
  {
    if ((executables[index].stages & VK_SHADER_STAGE_FRAGMENT_BIT) == 0)
    {
      continue;
    }
    VkPipelineExecutableInfoKHR executable{};
    executable.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR;
    executable.pipeline = pipeline;
    executable.executableIndex = index;
    std::uint32_t rows = 0;
    check(statistics(device.handle(), &executable, &rows, nullptr), "no statistics");
    VkPipelineExecutableStatisticKHR noStatistic{};
    noStatistic.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR;
    std::vector<VkPipelineExecutableStatisticKHR> found(rows, noStatistic);
    check(statistics(device.handle(), &executable, &rows, found.data()), "no statistics");
    Compilation compilation;
    compilation.SubgroupSize = executables[index].subgroupSize;
    for (const VkPipelineExecutableStatisticKHR& statistic : found)
    {
      compilation.Statistics[statistic.name] = numberOf(statistic);
    }
    return compilation;
  }
  throw std::runtime_error("the pipeline has no fragment shader");
}
} // namespace

Compilation compile(const Device& device, const SpirvWords& vertex, const SpirvWords& fragment)
{
  const SpirvInterface interface = interfaceOf(fragment);
  const OwnedModule vertexModule(
    device, vkCreateShaderModule, moduleInfo(vertex), "no vertex shader");
  const OwnedModule fragmentModule(
    device, vkCreateShaderModule, moduleInfo(fragment), "no fragment shader");
  const std::vector<VkDescriptorSetLayoutBinding> bindings = bindingsOf(interface);
  const OwnedSetLayout set(
    device, vkCreateDescriptorSetLayout, setInfo(bindings), "no layout of a descriptor set");
  const VkDescriptorSetLayout setHandle = *set;
  const OwnedLayout layout(
    device, vkCreatePipelineLayout, layoutInfo(setHandle), "no layout of a pipeline");
  const Targets targets(interface.Outputs);
  const OwnedRenderPass renderPass(device, vkCreateRenderPass, targets.info(), "no render pass");
  const VkPipelineShaderStageCreateInfo stages[] = { stageInfo(
                                                       VK_SHADER_STAGE_VERTEX_BIT, *vertexModule),
    stageInfo(VK_SHADER_STAGE_FRAGMENT_BIT, *fragmentModule) };
  const State state(interface.Outputs);
  VkGraphicsPipelineCreateInfo info = state.info();
  info.stageCount = 2;
  info.pStages = stages;
  info.layout = *layout;
  info.renderPass = *renderPass;
  const OwnedPipeline pipeline(device, createPipeline, info, "the shader was not compiled");
  return statisticsOf(device, *pipeline);
}
} // namespace tetmarch::gpu
