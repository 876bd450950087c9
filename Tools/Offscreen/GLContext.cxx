// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GLContext.h"

#include <cstdlib>

namespace tetmarch
{

std::unique_ptr<GLContext> MakeGLContext(std::string& error)
{
  const char* variable = std::getenv("TETMARCH_GL");
  static std::string backend = variable ? variable : "";
  std::unique_ptr<GLContext> context;
  if (backend == "egl")
  {
    context = MakeEGLContext(error);
  }
  else if (backend == "osmesa")
  {
    context = MakeOSMesaContext(error);
  }
  else if (backend.empty())
  {
    context = MakeEGLContext(error);
    if (context)
    {
      backend = "egl";
    }
    else
    {
      std::string osmesaError;
      context = MakeOSMesaContext(osmesaError);
      error = context ? "" : error + "; " + osmesaError;
      backend = context ? "osmesa" : "";
    }
  }
  else
  {
    error = "TETMARCH_GL is '" + backend + "'; it must be egl, osmesa or unset";
  }
  return context;
}

} // namespace tetmarch
