// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/Driver.h"

#include "vtkOpenGLRenderUtilities.h" // the GL

#include <cstring>

namespace tetmarch
{

bool hasExtension(const char* name)
{
  int count = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (int i = 0; i < count; ++i)
  {
    const auto* extension = reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, i));
    if (extension && std::strcmp(extension, name) == 0)
    {
      return true;
    }
  }
  return false;
}

std::string driverDefines()
{
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const bool skipsHelpers =
    renderer && std::strstr(renderer, "llvmpipe") && hasExtension("GL_ARB_ES3_1_compatibility");
  return skipsHelpers ? "#define TETMARCH_SKIPS_HELPERS 1\n" : "";
}

} // namespace tetmarch
