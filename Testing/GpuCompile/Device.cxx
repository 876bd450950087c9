// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Device.h"

#include <cstdint>
#include <stdexcept>

namespace tetmarch::gpu
{
namespace
{
VkInstance makeInstance()
{
  VkApplicationInfo application{};
  application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
  application.apiVersion = VK_API_VERSION_1_2;
  VkInstanceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
  info.pApplicationInfo = &application;
  VkInstance instance = VK_NULL_HANDLE;
  check(vkCreateInstance(&info, nullptr, &instance), "there is no Vulkan driver");
  return instance;
}

VkPhysicalDevice firstDevice(VkInstance instance)
{
  std::uint32_t count = 1;
  VkPhysicalDevice device = VK_NULL_HANDLE;
  vkEnumeratePhysicalDevices(instance, &count, &device); // VK_INCOMPLETE where there are more
  if (count == 0)
  {
    throw std::runtime_error("the Vulkan driver has no device");
  }
  return device;
}

VkDevice makeDevice(VkPhysicalDevice physical)
{
  VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR statistics{};
  statistics.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR;
  statistics.pipelineExecutableInfo = VK_TRUE;
  VkPhysicalDeviceFeatures features{};
  vkGetPhysicalDeviceFeatures(physical, &features);
  features.robustBufferAccess = VK_FALSE; // it adds instructions
  const float priority = 1.0f;
  VkDeviceQueueCreateInfo queue{};
  queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  const char* extension = VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME;
  VkDeviceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
  info.pNext = &statistics;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.enabledExtensionCount = 1;
  info.ppEnabledExtensionNames = &extension;
  info.pEnabledFeatures = &features;
  VkDevice device = VK_NULL_HANDLE;
  check(vkCreateDevice(physical, &info, nullptr, &device),
    "the device has no statistics of pipelines (VK_KHR_pipeline_executable_properties)");
  return device;
}
} // namespace

void check(VkResult result, const char* what)
{
  if (result != VK_SUCCESS)
  {
    throw std::runtime_error(what + std::string(", VkResult ") + std::to_string(result));
  }
}

Device::Device()
  : Instance(makeInstance())
{
  try
  {
    VkPhysicalDevice physical = firstDevice(this->Instance);
    VkPhysicalDeviceDriverProperties driver{};
    driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
    VkPhysicalDeviceProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    properties.pNext = &driver;
    vkGetPhysicalDeviceProperties2(physical, &properties);
    this->Name = properties.properties.deviceName;
    this->Driver = driver.driverName + std::string(" ") + driver.driverInfo;
    this->Handle = makeDevice(physical);
  }
  catch (...)
  {
    vkDestroyInstance(this->Instance, nullptr);
    throw;
  }
}

Device::~Device()
{
  vkDestroyDevice(this->Handle, nullptr);
  vkDestroyInstance(this->Instance, nullptr);
}

PFN_vkVoidFunction Device::find(const char* name) const
{
  PFN_vkVoidFunction function = vkGetDeviceProcAddr(this->Handle, name);
  if (!function)
  {
    throw std::runtime_error(std::string("the device has no ") + name);
  }
  return function;
}
} // namespace tetmarch::gpu
