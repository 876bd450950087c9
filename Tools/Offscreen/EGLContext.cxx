// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GLContext.h"

#if __has_include(<EGL/egl.h>)

#include "EGLDisplays.h"
#include "EGLLibrary.h"
#include "GLFunctions.h"

namespace
{
class EGLGLContext final : public tetmarch::GLContext
{
public:
  EGLGLContext(
    std::shared_ptr<tetmarch::EGLDisplayHolder> display, EGLContext context, EGLSurface surface)
    : Display(std::move(display))
    , Context(context)
    , Surface(surface)
  {
  }

  ~EGLGLContext() override
  {
    const auto& egl = tetmarch::EGLLibrary::Get();
    if (this->IsCurrent())
    {
      egl.MakeCurrent(this->Display->Display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    egl.DestroyContext(this->Display->Display, this->Context);
    if (this->Surface != EGL_NO_SURFACE)
    {
      egl.DestroySurface(this->Display->Display, this->Surface);
    }
  }

  const char* GetBackendName() const override { return "EGL"; }

  bool MakeCurrent() override
  {
    return this->IsCurrent() || tetmarch::EGLLibrary::Get().MakeCurrent(this->Display->Display,
                                  this->Surface, this->Surface, this->Context) == EGL_TRUE;
  }

  bool IsCurrent() const override
  {
    return tetmarch::EGLLibrary::Get().GetCurrentContext() == this->Context;
  }

private:
  std::shared_ptr<tetmarch::EGLDisplayHolder> Display;
  EGLContext Context;
  EGLSurface Surface;
};

std::unique_ptr<tetmarch::GLContext> MakeContextOn(
  std::shared_ptr<tetmarch::EGLDisplayHolder> holder)
{
  const auto& egl = tetmarch::EGLLibrary::Get();
  EGLDisplay display = holder->Display;
  const EGLint configAttributes[] = { EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
    EGL_OPENGL_BIT, EGL_RED_SIZE, 8, EGL_GREEN_SIZE, 8, EGL_BLUE_SIZE, 8, EGL_ALPHA_SIZE, 8,
    EGL_DEPTH_SIZE, 16, EGL_NONE };
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!egl.BindAPI(EGL_OPENGL_API) ||
      !egl.ChooseConfig(display, configAttributes, &config, 1, &count) || count < 1)
  {
    return nullptr;
  }
  for (const auto& version : tetmarch::GLVersions)
  {
    const EGLint contextAttributes[] = { EGL_CONTEXT_MAJOR_VERSION, version[0],
      EGL_CONTEXT_MINOR_VERSION, version[1], EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE };
    EGLContext context = egl.CreateContext(display, config, EGL_NO_CONTEXT, contextAttributes);
    if (context == EGL_NO_CONTEXT)
    {
      continue;
    }
    const EGLint surfaceAttributes[] = { EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE };
    EGLSurface surface = egl.CreatePbufferSurface(display, config, surfaceAttributes);
    auto result = std::make_unique<EGLGLContext>(std::move(holder), context, surface);
    return surface != EGL_NO_SURFACE && result->MakeCurrent() ? std::move(result) : nullptr;
  }
  return nullptr;
}
} // namespace

namespace tetmarch
{

std::unique_ptr<GLContext> MakeEGLContext(std::string& error)
{
  const EGLLibrary& egl = EGLLibrary::Get();
  if (!egl.Complete)
  {
    error = egl.Library ? "libEGL is older than EGL 1.4"
                        : "libEGL can't be opened (" + egl.Library.GetError() + ")";
    return nullptr;
  }
  std::unique_ptr<GLContext> context;
  ForEachEGLDisplay(
    [&context](std::shared_ptr<EGLDisplayHolder> display)
    {
      context = MakeContextOn(std::move(display));
      return context != nullptr;
    });
  if (!context)
  {
    error = "no EGL display gives a context of GL 3.2 or later";
    return nullptr;
  }
  SetGLFunctionLoader([](const char* name)
    { return reinterpret_cast<GLFunction>(EGLLibrary::Get().GetProcAddress(name)); });
  return context;
}

} // namespace tetmarch

#else

std::unique_ptr<tetmarch::GLContext> tetmarch::MakeEGLContext(std::string& error)
{
  error = "built without EGL, since EGL/egl.h was missing (package libegl-dev)";
  return nullptr;
}

#endif
