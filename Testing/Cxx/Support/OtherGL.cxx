// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OtherGL.h"

#include "GLReplacements.h"

#include <algorithm>

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

GLReplacements<OtherGL> Replaced;
} // namespace

OtherGL::OtherGL(const GLAnswers& answers)
{
  Answers = answers;
  MostTexels.clear();
  Refusals = 0;
  Error = GL_NO_ERROR;
  TETMARCH_REPLACE_GL(Replaced, TexBuffer, texBuffer);
  TETMARCH_REPLACE_GL_1(Replaced, GetString, getString);
  TETMARCH_REPLACE_GL_1(Replaced, GetError, getError);
  TETMARCH_REPLACE_GL_1(Replaced, GetIntegerv, getIntegerv);
  TETMARCH_REPLACE_GL_1(Replaced, GetTexLevelParameteriv, getTexLevelParameteriv);
  TETMARCH_REPLACE_GL_1(Replaced, TexImage2D, texImage2D);
}

OtherGL::~OtherGL() { Replaced.restore(); }

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
