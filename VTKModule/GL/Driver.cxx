// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/Driver.h"

#include "vtkOpenGLRenderUtilities.h" // the GL

#include <algorithm>
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

// Mesa's softpipe claims 65,536 texels, but reads the first ones again from byte 524,288 of a
// buffer on (Mesa 22.3): its cache numbers tiles of 32 bytes by 14 bits.
constexpr std::size_t MostTexelsOfSoftpipe = 524288 / 16;

std::string_view textOf(GLenum name)
{
  const auto* text = reinterpret_cast<const char*>(glGetString(name));
  return text ? text : "";
}

bool isSoftpipe() { return textOf(GL_RENDERER).find("softpipe") != std::string_view::npos; }

// A proxy has no size if the GL can't make such a texture.
bool hasDepthTextures()
{
  int width = 0;
  glTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 1, 1, 0, GL_DEPTH_COMPONENT,
    GL_UNSIGNED_INT, nullptr);
  glGetTexLevelParameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
  return width > 0;
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

std::size_t mostTexels()
{
  int most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  const std::size_t claimed = most > 0 ? static_cast<std::size_t>(most) : 0;
  return isSoftpipe() ? std::min(claimed, MostTexelsOfSoftpipe) : claimed;
}

bool writesArrays() { return !isSoftpipe(); }

int textureUnits(bool ofCompute)
{
  int most = 0;
  glGetIntegerv(ofCompute ? GL_MAX_COMPUTE_TEXTURE_IMAGE_UNITS : GL_MAX_TEXTURE_IMAGE_UNITS, &most);
  return most;
}

std::string describeMissing()
{
  const bool isForEmbedded = textOf(GL_VERSION).substr(0, 9) == "OpenGL ES";
  std::string missing;
  if (isForEmbedded || !hasVersion(3, 2))
  {
    missing = "OpenGL 3.2 or later";
  }
  else if (mostTexels() == 0)
  {
    missing = "texture buffers";
  }
  else if (!hasDepthTextures())
  {
    missing = "textures of depths";
  }
  return missing.empty()
           ? missing
           : "Volumes need " + missing + ", but this GL has none: it is " +
               std::string(textOf(GL_VERSION)) + ", " + std::string(textOf(GL_RENDERER)) +
               ". Install a newer driver, or draw without the graphics card: with Mesa set "
               "LIBGL_ALWAYS_SOFTWARE=1 in the environment.";
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
  defines += isLlvmpipe ? "#define TETMARCH_LIMITS_TURNS 1\n" : "";
  defines += hasExtension("GL_ARB_texture_gather") ? "#define TETMARCH_HAS_GATHER 1\n" : "";
  defines += hasExtension("GL_ARB_gpu_shader5") ? "#define TETMARCH_HAS_PRECISE 1\n" : "";
  return defines;
}

} // namespace tetmarch
