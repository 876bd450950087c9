// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The functions of libEGL that are needed, found at run time.
 */
#ifndef tetmarch_EGLLibrary_h
#define tetmarch_EGLLibrary_h

#include "SharedLibrary.h"

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace tetmarch
{

struct EGLLibrary
{
  SharedLibrary Library{ "libEGL.so.1", "libEGL.so" };
  decltype(&eglBindAPI) BindAPI = nullptr;
  decltype(&eglChooseConfig) ChooseConfig = nullptr;
  decltype(&eglCreateContext) CreateContext = nullptr;
  decltype(&eglCreatePbufferSurface) CreatePbufferSurface = nullptr;
  decltype(&eglDestroyContext) DestroyContext = nullptr;
  decltype(&eglDestroySurface) DestroySurface = nullptr;
  decltype(&eglGetCurrentContext) GetCurrentContext = nullptr;
  decltype(&eglGetDisplay) GetDisplay = nullptr;
  decltype(&eglGetProcAddress) GetProcAddress = nullptr;
  decltype(&eglInitialize) Initialize = nullptr;
  decltype(&eglMakeCurrent) MakeCurrent = nullptr;
  decltype(&eglQueryString) QueryString = nullptr;
  decltype(&eglTerminate) Terminate = nullptr;
  bool Complete =
    Library.Find("eglBindAPI", BindAPI) && Library.Find("eglChooseConfig", ChooseConfig) &&
    Library.Find("eglCreateContext", CreateContext) &&
    Library.Find("eglCreatePbufferSurface", CreatePbufferSurface) &&
    Library.Find("eglDestroyContext", DestroyContext) &&
    Library.Find("eglDestroySurface", DestroySurface) &&
    Library.Find("eglGetCurrentContext", GetCurrentContext) &&
    Library.Find("eglGetDisplay", GetDisplay) &&
    Library.Find("eglGetProcAddress", GetProcAddress) &&
    Library.Find("eglInitialize", Initialize) && Library.Find("eglMakeCurrent", MakeCurrent) &&
    Library.Find("eglQueryString", QueryString) && Library.Find("eglTerminate", Terminate);

  static const EGLLibrary& Get()
  {
    static const EGLLibrary library;
    return library;
  }
};

} // namespace tetmarch

#endif
