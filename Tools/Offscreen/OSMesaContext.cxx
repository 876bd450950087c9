// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GLContext.h"

#if __has_include(<GL/osmesa.h>)

#include "GLFunctions.h"
#include "SharedLibrary.h"

#include <GL/osmesa.h>

#include <array>

namespace
{
struct OSMesaLibrary
{
  tetmarch::SharedLibrary Library{ "libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so" };
  decltype(&OSMesaCreateContextAttribs) CreateContextAttribs = nullptr;
  decltype(&OSMesaDestroyContext) DestroyContext = nullptr;
  decltype(&OSMesaGetCurrentContext) GetCurrentContext = nullptr;
  decltype(&OSMesaGetProcAddress) GetProcAddress = nullptr;
  decltype(&OSMesaMakeCurrent) MakeCurrent = nullptr;
  bool Complete = Library.Find("OSMesaCreateContextAttribs", CreateContextAttribs) &&
                  Library.Find("OSMesaDestroyContext", DestroyContext) &&
                  Library.Find("OSMesaGetCurrentContext", GetCurrentContext) &&
                  Library.Find("OSMesaGetProcAddress", GetProcAddress) &&
                  Library.Find("OSMesaMakeCurrent", MakeCurrent);

  static const OSMesaLibrary& Get()
  {
    static const OSMesaLibrary library;
    return library;
  }
};

class OSMesaGLContext final : public tetmarch::GLContext
{
public:
  explicit OSMesaGLContext(OSMesaContext context)
    : Context(context)
  {
  }

  ~OSMesaGLContext() override
  {
    const auto& library = OSMesaLibrary::Get();
    if (this->IsCurrent())
    {
      library.MakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    }
    library.DestroyContext(this->Context);
  }

  const char* GetBackendName() const override { return "OSMesa"; }

  bool MakeCurrent() override
  {
    return this->IsCurrent() || OSMesaLibrary::Get().MakeCurrent(this->Context, this->Pixels.data(),
                                  GL_UNSIGNED_BYTE, Size, Size) == GL_TRUE;
  }

  bool IsCurrent() const override
  {
    return OSMesaLibrary::Get().GetCurrentContext() == this->Context;
  }

private:
  static constexpr int Size = 16;
  OSMesaContext Context;
  std::array<unsigned char, Size * Size * 4> Pixels;
};
} // namespace

namespace tetmarch
{

std::unique_ptr<GLContext> MakeOSMesaContext(std::string& error)
{
  const OSMesaLibrary& library = OSMesaLibrary::Get();
  if (!library.Complete)
  {
    error = library.Library ? "libOSMesa is too old: OSMesaCreateContextAttribs is missing"
                            : "libOSMesa can't be opened (" + library.Library.GetError() + ")";
    return nullptr;
  }
  for (const auto& version : GLVersions)
  {
    const int attributes[] = { OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 24,
      OSMESA_STENCIL_BITS, 8, OSMESA_ACCUM_BITS, 0, OSMESA_PROFILE, OSMESA_CORE_PROFILE,
      OSMESA_CONTEXT_MAJOR_VERSION, version[0], OSMESA_CONTEXT_MINOR_VERSION, version[1], 0 };
    if (OSMesaContext context = library.CreateContextAttribs(attributes, nullptr))
    {
      SetGLFunctionLoader([](const char* name)
        { return reinterpret_cast<GLFunction>(OSMesaLibrary::Get().GetProcAddress(name)); });
      return std::make_unique<OSMesaGLContext>(context);
    }
  }
  error = "libOSMesa gives no context of GL 3.2 or later";
  return nullptr;
}

} // namespace tetmarch

#else

std::unique_ptr<tetmarch::GLContext> tetmarch::MakeOSMesaContext(std::string& error)
{
  error = "built without OSMesa, since GL/osmesa.h was missing (package libosmesa6-dev)";
  return nullptr;
}

#endif
