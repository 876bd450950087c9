// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/Driver.h"

#include "vtkOpenGLRenderUtilities.h" // the GL

#include <cstdlib>
#include <cstring>
#include <string_view>

namespace tetmarch
{
namespace
{

// The last version that is known to need no care of helper invocations. 26 needs it; the versions
// between were not tried.
constexpr int LastMesaWithoutCare = 22;

std::string_view textOf(GLenum name)
{
  const auto* text = reinterpret_cast<const char*>(glGetString(name));
  return text ? text : "";
}

} // namespace

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

bool hasVersion(int major, int minor)
{
  GLint here[2] = {};
  glGetIntegerv(GL_MAJOR_VERSION, &here[0]);
  glGetIntegerv(GL_MINOR_VERSION, &here[1]);
  return here[0] > major || (here[0] == major && here[1] >= minor);
}

std::string driverDefines()
{
  // Such as "4.5 (Core Profile) Mesa 26.1.6-1".
  const std::string_view renderer = textOf(GL_RENDERER), version = textOf(GL_VERSION);
  const std::size_t mesa = version.find("Mesa ");
  const bool isLlvmpipe =
    renderer.find("llvmpipe") != std::string_view::npos && mesa != std::string_view::npos;
  const bool skipsHelpers = isLlvmpipe &&
                            std::atoi(version.data() + mesa + 5) > LastMesaWithoutCare &&
                            hasExtension("GL_ARB_ES3_1_compatibility");
  std::string defines = skipsHelpers ? "#define TETMARCH_SKIPS_HELPERS 1\n" : "";
  defines += hasExtension("GL_ARB_texture_gather") ? "#define TETMARCH_HAS_GATHER 1\n" : "";
  defines += hasExtension("GL_ARB_gpu_shader5") ? "#define TETMARCH_HAS_PRECISE 1\n" : "";
  return defines;
}

} // namespace tetmarch
