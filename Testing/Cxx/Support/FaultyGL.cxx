// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FaultyGL.h"

#include "GLReplacements.h"

namespace tetmarch::testing
{
namespace
{
// What is to fail, and what did.
struct
{
  bool Active = false;
  Fault Kind = Fault::CompileStatus;
  int Call = 0;
  bool Happened = false;
  GLenum Error = GL_NO_ERROR; // for the next glGetError()
  int MostTexels = 0;
  std::function<std::string(const std::string&)> Rewrite;
} Plan;

bool fails(Fault kind)
{
  if (!Plan.Active || Plan.Kind != kind || Plan.Call-- != 0)
  {
    return false;
  }
  Plan.Happened = true;
  return true;
}

bool failsWith(Fault kind, GLenum error)
{
  const bool fault = fails(kind);
  Plan.Error = fault ? error : Plan.Error;
  return fault;
}

// The GL's functions, as they are.
PFNGLGETSHADERIVPROC GetShaderiv;
PFNGLGETPROGRAMIVPROC GetProgramiv;
PFNGLSHADERSOURCEPROC ShaderSource;
PFNGLCHECKFRAMEBUFFERSTATUSPROC CheckFramebufferStatus;
PFNGLBUFFERDATAPROC BufferData;
PFNGLTEXBUFFERPROC TexBuffer;
PFNGLBLITFRAMEBUFFERPROC BlitFramebuffer;
GLenum(GLAPIENTRY* GetError)();
void(GLAPIENTRY* GetIntegerv)(GLenum, GLint*);
void(GLAPIENTRY* TexImage2D)(
  GLenum, GLint, GLint, GLsizei, GLsizei, GLint, GLenum, GLenum, const void*);

void GLAPIENTRY getShaderiv(GLuint shader, GLenum name, GLint* value)
{
  GetShaderiv(shader, name, value);
  if (name == GL_COMPILE_STATUS && fails(Fault::CompileStatus))
  {
    *value = 0;
  }
}
void GLAPIENTRY getProgramiv(GLuint program, GLenum name, GLint* value)
{
  GetProgramiv(program, name, value);
  if (name == GL_LINK_STATUS && fails(Fault::LinkStatus))
  {
    *value = 0;
  }
}
void GLAPIENTRY shaderSource(
  GLuint shader, GLsizei count, const GLchar* const* texts, const GLint* lengths)
{
  if (!Plan.Rewrite || count != 1 || lengths)
  {
    ShaderSource(shader, count, texts, lengths);
    return;
  }
  const std::string text = Plan.Rewrite(texts[0]);
  Plan.Happened = Plan.Happened || text != texts[0];
  const GLchar* rewritten = text.c_str();
  ShaderSource(shader, 1, &rewritten, nullptr);
}
GLenum GLAPIENTRY checkFramebufferStatus(GLenum target)
{
  return fails(Fault::FramebufferStatus) ? GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT
                                         : CheckFramebufferStatus(target);
}
void GLAPIENTRY bufferData(GLenum target, GLsizeiptr size, const void* data, GLenum usage)
{
  if (!failsWith(Fault::BufferData, GL_OUT_OF_MEMORY))
  {
    BufferData(target, size, data, usage);
  }
}
void GLAPIENTRY texBuffer(GLenum target, GLenum format, GLuint buffer)
{
  if (!failsWith(Fault::TexBuffer, GL_OUT_OF_MEMORY))
  {
    TexBuffer(target, format, buffer);
  }
}
void GLAPIENTRY blitFramebuffer(GLint a, GLint b, GLint c, GLint d, GLint e, GLint f, GLint g,
  GLint h, GLbitfield mask, GLenum filter)
{
  if (!failsWith(Fault::Blit, GL_INVALID_OPERATION))
  {
    BlitFramebuffer(a, b, c, d, e, f, g, h, mask, filter);
  }
}

GLenum GLAPIENTRY getError()
{
  const GLenum error = GetError();
  const GLenum planned = Plan.Error;
  Plan.Error = GL_NO_ERROR;
  return error != GL_NO_ERROR ? error : planned;
}
void GLAPIENTRY getIntegerv(GLenum name, GLint* value)
{
  GetIntegerv(name, value);
  if (name == GL_MAX_TEXTURE_BUFFER_SIZE && Plan.MostTexels > 0)
  {
    *value = Plan.MostTexels;
    Plan.Happened = Plan.Happened || !Plan.Active;
  }
}
void GLAPIENTRY texImage2D(GLenum target, GLint level, GLint internal, GLsizei width,
  GLsizei height, GLint border, GLenum format, GLenum type, const void* data)
{
  if (!failsWith(Fault::TexImage, GL_OUT_OF_MEMORY))
  {
    TexImage2D(target, level, internal, width, height, border, format, type, data);
  }
}

GLReplacements<FaultyGL> Replaced;

void begin()
{
  Plan.Happened = false;
  Plan.Error = GL_NO_ERROR;
  TETMARCH_REPLACE_GL(Replaced, GetShaderiv, getShaderiv);
  TETMARCH_REPLACE_GL(Replaced, GetProgramiv, getProgramiv);
  TETMARCH_REPLACE_GL(Replaced, ShaderSource, shaderSource);
  TETMARCH_REPLACE_GL(Replaced, CheckFramebufferStatus, checkFramebufferStatus);
  TETMARCH_REPLACE_GL(Replaced, BufferData, bufferData);
  TETMARCH_REPLACE_GL(Replaced, TexBuffer, texBuffer);
  TETMARCH_REPLACE_GL(Replaced, BlitFramebuffer, blitFramebuffer);
  TETMARCH_REPLACE_GL_1(Replaced, GetError, getError);
  TETMARCH_REPLACE_GL_1(Replaced, GetIntegerv, getIntegerv);
  TETMARCH_REPLACE_GL_1(Replaced, TexImage2D, texImage2D);
}
} // namespace

const char* nameOf(Fault fault)
{
  constexpr const char* names[] = { "compile status", "link status", "framebuffer status",
    "buffer data", "texture buffer", "texture image", "blit" };
  return names[static_cast<int>(fault)];
}

FaultyGL::FaultyGL(Fault fault, int call)
{
  Plan.Active = true;
  Plan.Kind = fault;
  Plan.Call = call;
  begin();
}

FaultyGL::FaultyGL(const std::function<std::string(const std::string&)>& rewrite)
{
  Plan.Rewrite = rewrite;
  begin();
}

FaultyGL::FaultyGL(int mostTexels)
{
  Plan.MostTexels = mostTexels;
  begin();
}

FaultyGL::FaultyGL(int mostTexels, Fault fault, int call)
  : FaultyGL(fault, call)
{
  Plan.MostTexels = mostTexels;
}

FaultyGL::~FaultyGL()
{
  Replaced.restore();
  Plan.Active = false;
  Plan.MostTexels = 0;
  Plan.Rewrite = nullptr;
}

bool FaultyGL::happened() const { return Plan.Happened; }
} // namespace tetmarch::testing
