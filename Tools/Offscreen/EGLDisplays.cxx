// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#if __has_include(<EGL/egl.h>)

#include "EGLDisplays.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

namespace
{
std::weak_ptr<tetmarch::EGLDisplayHolder> DisplayInUse;

bool Contains(const char* extensions, const char* name)
{
  return extensions && (std::string(" ") + extensions + " ").find(std::string(" ") + name + " ") !=
                         std::string::npos;
}

template <typename Function>
bool FindExtension(const char* name, Function& function)
{
  function = reinterpret_cast<Function>(tetmarch::EGLLibrary::Get().GetProcAddress(name));
  return function != nullptr;
}

std::vector<EGLDeviceEXT> ListDevices()
{
  PFNEGLQUERYDEVICESEXTPROC queryDevices = nullptr;
  EGLint count = 0;
  if (!FindExtension("eglQueryDevicesEXT", queryDevices) || !queryDevices(0, nullptr, &count) ||
      count < 1)
  {
    return {};
  }
  std::vector<EGLDeviceEXT> devices(count);
  queryDevices(count, devices.data(), &count);
  devices.resize(count);
  return devices;
}

/// Software: devices that Mesa computes on the CPU.
void PutSoftwareLast(std::vector<EGLDeviceEXT>& devices)
{
  PFNEGLQUERYDEVICESTRINGEXTPROC queryDeviceString = nullptr;
  if (FindExtension("eglQueryDeviceStringEXT", queryDeviceString))
  {
    std::stable_partition(devices.begin(), devices.end(),
      [queryDeviceString](EGLDeviceEXT device)
      { return !Contains(queryDeviceString(device, EGL_EXTENSIONS), "EGL_MESA_device_software"); });
  }
}

/// Not initialized yet.
std::vector<EGLDisplay> ListDisplays()
{
  const auto& egl = tetmarch::EGLLibrary::Get();
  const char* chosenDevice = std::getenv("VTK_DEFAULT_EGL_DEVICE_INDEX");
  const char* extensions = egl.QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  PFNEGLGETPLATFORMDISPLAYEXTPROC getPlatformDisplay = nullptr;
  std::vector<EGLDisplay> displays;
  if (FindExtension("eglGetPlatformDisplayEXT", getPlatformDisplay))
  {
    if (Contains(extensions, "EGL_EXT_platform_device"))
    {
      auto devices = ListDevices();
      if (chosenDevice)
      {
        const auto index = std::strtoul(chosenDevice, nullptr, 10);
        devices = index < devices.size() ? std::vector<EGLDeviceEXT>{ devices[index] }
                                         : std::vector<EGLDeviceEXT>{};
      }
      else
      {
        PutSoftwareLast(devices);
      }
      for (EGLDeviceEXT device : devices)
      {
        displays.push_back(getPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
      }
    }
    if (chosenDevice)
    {
      return displays;
    }
    if (Contains(extensions, "EGL_MESA_platform_surfaceless"))
    {
      displays.push_back(
        getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    }
  }
  displays.push_back(egl.GetDisplay(EGL_DEFAULT_DISPLAY));
  return displays;
}
} // namespace

namespace tetmarch
{

EGLDisplayHolder::~EGLDisplayHolder() { EGLLibrary::Get().Terminate(this->Display); }

void ForEachEGLDisplay(const std::function<bool(std::shared_ptr<EGLDisplayHolder>)>& use)
{
  if (auto display = DisplayInUse.lock())
  {
    use(display);
    return;
  }
  for (EGLDisplay display : ListDisplays())
  {
    if (display != EGL_NO_DISPLAY && EGLLibrary::Get().Initialize(display, nullptr, nullptr))
    {
      auto holder = std::make_shared<EGLDisplayHolder>(display);
      if (use(holder))
      {
        DisplayInUse = holder;
        return;
      }
    }
  }
}

} // namespace tetmarch

#endif
