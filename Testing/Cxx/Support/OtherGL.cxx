// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OtherGL.h"

#if TETMARCH_GL_1_IS_LINKED
#include "GLFunctions.h"
#endif

#include <algorithm>
#include <cstring>

namespace tetmarch::testing
{
namespace
{
GLAnswers Answers;
std::map<GLenum, std::size_t> MostTexels; // by format
int Refusals = 0;
GLenum Error = GL_NO_ERROR; // for the next glGetError()

// The GL's functions, as they are.
const GLubyte*(GLAPIENTRY* GetString)(GLenum);
GLenum(GLAPIENTRY* GetError)();
void(GLAPIENTRY* GetIntegerv)(GLenum, GLint*);
void(GLAPIENTRY* GetTexLevelParameteriv)(GLenum, GLint, GLenum, GLint*);
void(GLAPIENTRY* TexImage2D)(
  GLenum, GLint, GLint, GLsizei, GLsizei, GLint, GLenum, GLenum, const void*);
PFNGLTEXBUFFERPROC TexBuffer;

bool refuses(const std::vector<GLenum>& refused, GLenum name)
{
  if (std::find(refused.begin(), refused.end(), name) == refused.end())
  {
    return false;
  }
  ++Refusals;
  Error = GL_INVALID_ENUM;
  return true;
}

const GLubyte* GLAPIENTRY getString(GLenum name)
{
  const auto answer = Answers.Strings.find(name);
  return answer == Answers.Strings.end() ? GetString(name)
                                         : reinterpret_cast<const GLubyte*>(answer->second.c_str());
}
GLenum GLAPIENTRY getError()
{
  const GLenum error = GetError();
  const GLenum ours = Error;
  Error = GL_NO_ERROR;
  return error != GL_NO_ERROR ? error : ours;
}
void GLAPIENTRY getIntegerv(GLenum name, GLint* value)
{
  const auto answer = Answers.Integers.find(name);
  if (answer != Answers.Integers.end())
  {
    *value = answer->second;
  }
  else if (!refuses(Answers.RefusedIntegers, name))
  {
    GetIntegerv(name, value);
  }
}
void GLAPIENTRY getTexLevelParameteriv(GLenum target, GLint level, GLenum name, GLint* value)
{
  if (!refuses(Answers.RefusedLevelParameters, name))
  {
    GetTexLevelParameteriv(target, level, name, value);
  }
}
void GLAPIENTRY texImage2D(GLenum target, GLint level, GLint internal, GLsizei width,
  GLsizei height, GLint border, GLenum format, GLenum type, const void* data)
{
  const bool refused = !Answers.HasDepthTextures && format == GL_DEPTH_COMPONENT;
  // A proxy of a size that the GL refuses has none.
  TexImage2D(target, level, internal, refused && target == GL_PROXY_TEXTURE_2D ? 1 << 24 : width,
    height, border, format, type, data);
}

std::size_t bytesOf(GLenum format)
{
  switch (format)
  {
    case GL_R8UI:
      return 1;
    case GL_R32F:
    case GL_R32UI:
      return 4;
    case GL_RG32F:
    case GL_RG32UI:
    case GL_RGBA16F:
      return 8;
    default:
      return 16;
  }
}

void GLAPIENTRY texBuffer(GLenum target, GLenum format, GLuint buffer)
{
  TexBuffer(target, format, buffer);
  GLint bytes = 0;
  glBindBuffer(GL_TEXTURE_BUFFER, buffer);
  glGetBufferParameteriv(GL_TEXTURE_BUFFER, GL_BUFFER_SIZE, &bytes);
  std::size_t& most = MostTexels[format];
  most = std::max(most, static_cast<std::size_t>(bytes) / bytesOf(format));
}

#if TETMARCH_GL_1_IS_LINKED

GLFunctionLoader Loader = nullptr;

template <typename Function>
void load(Function& function, const char* name)
{
  function = reinterpret_cast<Function>(Loader(name));
}

GLFunction answeringFunction(const char* name)
{
  const auto is = [name](const char* other) { return std::strcmp(name, other) == 0; };
  return is("glGetString")                ? reinterpret_cast<GLFunction>(&getString)
         : is("glGetError")               ? reinterpret_cast<GLFunction>(&getError)
         : is("glGetIntegerv")            ? reinterpret_cast<GLFunction>(&getIntegerv)
         : is("glGetTexLevelParameteriv") ? reinterpret_cast<GLFunction>(&getTexLevelParameteriv)
         : is("glTexImage2D")             ? reinterpret_cast<GLFunction>(&texImage2D)
                                          : Loader(name);
}

void replaceGL1()
{
  Loader = SetGLFunctionLoader(&answeringFunction);
  load(GetString, "glGetString");
  load(GetError, "glGetError");
  load(GetIntegerv, "glGetIntegerv");
  load(GetTexLevelParameteriv, "glGetTexLevelParameteriv");
  load(TexImage2D, "glTexImage2D");
}

void restoreGL1() { SetGLFunctionLoader(Loader); }

#else

template <typename Function>
void replace(Function& kept, Function& pointer, Function replacement)
{
  kept = pointer;
  pointer = replacement;
}

void replaceGL1()
{
  replace(GetString, TETMARCH_GL_POINTER(GetString), &getString);
  replace(GetError, TETMARCH_GL_POINTER(GetError), &getError);
  replace(GetIntegerv, TETMARCH_GL_POINTER(GetIntegerv), &getIntegerv);
  replace(
    GetTexLevelParameteriv, TETMARCH_GL_POINTER(GetTexLevelParameteriv), &getTexLevelParameteriv);
  replace(TexImage2D, TETMARCH_GL_POINTER(TexImage2D), &texImage2D);
}

void restoreGL1()
{
  TETMARCH_GL_POINTER(GetString) = GetString;
  TETMARCH_GL_POINTER(GetError) = GetError;
  TETMARCH_GL_POINTER(GetIntegerv) = GetIntegerv;
  TETMARCH_GL_POINTER(GetTexLevelParameteriv) = GetTexLevelParameteriv;
  TETMARCH_GL_POINTER(TexImage2D) = TexImage2D;
}

#endif
} // namespace

OtherGL::OtherGL(const GLAnswers& answers)
{
  Answers = answers;
  MostTexels.clear();
  Refusals = 0;
  Error = GL_NO_ERROR;
  TexBuffer = TETMARCH_GL_POINTER(TexBuffer);
  TETMARCH_GL_POINTER(TexBuffer) = &texBuffer;
  replaceGL1();
}

OtherGL::~OtherGL()
{
  restoreGL1();
  TETMARCH_GL_POINTER(TexBuffer) = TexBuffer;
}

std::size_t OtherGL::mostTexelsMade(GLenum format) const { return MostTexels[format]; }

std::size_t OtherGL::mostTexelsMade() const
{
  std::size_t most = 0;
  for (const auto& [format, texels] : MostTexels)
  {
    most = std::max(most, texels);
  }
  return most;
}

int OtherGL::refusals() const { return Refusals; }
} // namespace tetmarch::testing
