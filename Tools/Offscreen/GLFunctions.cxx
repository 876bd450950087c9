// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GLFunctions.h"

#include <GL/gl.h>

#include <cstring>
#include <dlfcn.h>
#include <utility>

namespace
{
tetmarch::GLFunctionLoader Loader = nullptr;
}

namespace tetmarch
{

GLFunctionLoader SetGLFunctionLoader(GLFunctionLoader loader)
{
  return std::exchange(Loader, loader);
}

GLFunction FindGLFunction(const char* name)
{
  if (!Loader)
  {
    return reinterpret_cast<GLFunction>(dlsym(RTLD_NEXT, name));
  }
  // No backend has GLX, but some hand out a stub for any name that begins with gl.
  return std::strncmp(name, "glX", 3) == 0 ? nullptr : Loader(name);
}

} // namespace tetmarch

extern "C" __attribute__((visibility("default"))) tetmarch::GLFunction glXGetProcAddressARB(
  const GLubyte* name)
{
  return tetmarch::FindGLFunction(reinterpret_cast<const char*>(name));
}

// A function is looked up at its first call after the loader was set.
#define TETMARCH_FORWARD(result, name, parameters, arguments)                                      \
  extern "C" __attribute__((visibility("default"))) result name parameters                         \
  {                                                                                                \
    using Result = result;                                                                         \
    using Function = Result(*) parameters;                                                         \
    static Function call = nullptr;                                                                \
    static tetmarch::GLFunctionLoader finder = nullptr;                                            \
    if (!call || !finder || finder != Loader)                                                      \
    {                                                                                              \
      call = reinterpret_cast<Function>(tetmarch::FindGLFunction(#name));                          \
      finder = Loader;                                                                             \
    }                                                                                              \
    return call ? call arguments : Result();                                                       \
  }

// clang-format off
TETMARCH_FORWARD(void, glBindTexture, (GLenum t, GLuint n), (t, n))
TETMARCH_FORWARD(void, glBlendFunc, (GLenum s, GLenum d), (s, d))
TETMARCH_FORWARD(void, glClear, (GLbitfield m), (m))
TETMARCH_FORWARD(void, glClearColor, (GLclampf r, GLclampf g, GLclampf b, GLclampf a), (r, g, b, a))
TETMARCH_FORWARD(void, glClearDepth, (GLclampd d), (d))
TETMARCH_FORWARD(void, glClearStencil, (GLint s), (s))
TETMARCH_FORWARD(void, glColorMask, (GLboolean r, GLboolean g, GLboolean b, GLboolean a), (r, g, b, a))
TETMARCH_FORWARD(void, glCopyTexImage1D, (GLenum t, GLint l, GLenum f, GLint x, GLint y, GLsizei w, GLint b), (t, l, f, x, y, w, b))
TETMARCH_FORWARD(void, glCopyTexImage2D, (GLenum t, GLint l, GLenum f, GLint x, GLint y, GLsizei w, GLsizei h, GLint b), (t, l, f, x, y, w, h, b))
TETMARCH_FORWARD(void, glCopyTexSubImage1D, (GLenum t, GLint l, GLint o, GLint x, GLint y, GLsizei w), (t, l, o, x, y, w))
TETMARCH_FORWARD(void, glCopyTexSubImage2D, (GLenum t, GLint l, GLint o, GLint p, GLint x, GLint y, GLsizei w, GLsizei h), (t, l, o, p, x, y, w, h))
TETMARCH_FORWARD(void, glCullFace, (GLenum m), (m))
TETMARCH_FORWARD(void, glDeleteTextures, (GLsizei n, const GLuint* t), (n, t))
TETMARCH_FORWARD(void, glDepthFunc, (GLenum f), (f))
TETMARCH_FORWARD(void, glDepthMask, (GLboolean f), (f))
TETMARCH_FORWARD(void, glDepthRange, (GLclampd n, GLclampd f), (n, f))
TETMARCH_FORWARD(void, glDisable, (GLenum c), (c))
TETMARCH_FORWARD(void, glDrawArrays, (GLenum m, GLint f, GLsizei c), (m, f, c))
TETMARCH_FORWARD(void, glDrawBuffer, (GLenum m), (m))
TETMARCH_FORWARD(void, glDrawElements, (GLenum m, GLsizei c, GLenum t, const GLvoid* i), (m, c, t, i))
TETMARCH_FORWARD(void, glEnable, (GLenum c), (c))
TETMARCH_FORWARD(void, glFinish, (), ())
TETMARCH_FORWARD(void, glFlush, (), ())
TETMARCH_FORWARD(void, glFrontFace, (GLenum m), (m))
TETMARCH_FORWARD(void, glGenTextures, (GLsizei n, GLuint* t), (n, t))
TETMARCH_FORWARD(void, glGetBooleanv, (GLenum n, GLboolean* p), (n, p))
TETMARCH_FORWARD(void, glGetDoublev, (GLenum n, GLdouble* p), (n, p))
TETMARCH_FORWARD(GLenum, glGetError, (), ())
TETMARCH_FORWARD(void, glGetFloatv, (GLenum n, GLfloat* p), (n, p))
TETMARCH_FORWARD(void, glGetIntegerv, (GLenum n, GLint* p), (n, p))
TETMARCH_FORWARD(void, glGetPointerv, (GLenum n, GLvoid** p), (n, p))
TETMARCH_FORWARD(const GLubyte*, glGetString, (GLenum n), (n))
TETMARCH_FORWARD(void, glGetTexImage, (GLenum t, GLint l, GLenum f, GLenum y, GLvoid* p), (t, l, f, y, p))
TETMARCH_FORWARD(void, glGetTexLevelParameterfv, (GLenum t, GLint l, GLenum n, GLfloat* p), (t, l, n, p))
TETMARCH_FORWARD(void, glGetTexLevelParameteriv, (GLenum t, GLint l, GLenum n, GLint* p), (t, l, n, p))
TETMARCH_FORWARD(void, glGetTexParameterfv, (GLenum t, GLenum n, GLfloat* p), (t, n, p))
TETMARCH_FORWARD(void, glGetTexParameteriv, (GLenum t, GLenum n, GLint* p), (t, n, p))
TETMARCH_FORWARD(void, glHint, (GLenum t, GLenum m), (t, m))
TETMARCH_FORWARD(GLboolean, glIsEnabled, (GLenum c), (c))
TETMARCH_FORWARD(GLboolean, glIsTexture, (GLuint t), (t))
TETMARCH_FORWARD(void, glLineWidth, (GLfloat w), (w))
TETMARCH_FORWARD(void, glLogicOp, (GLenum o), (o))
TETMARCH_FORWARD(void, glPixelStoref, (GLenum n, GLfloat p), (n, p))
TETMARCH_FORWARD(void, glPixelStorei, (GLenum n, GLint p), (n, p))
TETMARCH_FORWARD(void, glPointSize, (GLfloat s), (s))
TETMARCH_FORWARD(void, glPolygonMode, (GLenum f, GLenum m), (f, m))
TETMARCH_FORWARD(void, glPolygonOffset, (GLfloat f, GLfloat u), (f, u))
TETMARCH_FORWARD(void, glReadBuffer, (GLenum m), (m))
TETMARCH_FORWARD(void, glReadPixels, (GLint x, GLint y, GLsizei w, GLsizei h, GLenum f, GLenum t, GLvoid* p), (x, y, w, h, f, t, p))
TETMARCH_FORWARD(void, glScissor, (GLint x, GLint y, GLsizei w, GLsizei h), (x, y, w, h))
TETMARCH_FORWARD(void, glStencilFunc, (GLenum f, GLint r, GLuint m), (f, r, m))
TETMARCH_FORWARD(void, glStencilMask, (GLuint m), (m))
TETMARCH_FORWARD(void, glStencilOp, (GLenum f, GLenum z, GLenum p), (f, z, p))
TETMARCH_FORWARD(void, glTexEnvi, (GLenum t, GLenum n, GLint p), (t, n, p))
TETMARCH_FORWARD(void, glTexImage1D, (GLenum t, GLint l, GLint i, GLsizei w, GLint b, GLenum f, GLenum y, const GLvoid* p), (t, l, i, w, b, f, y, p))
TETMARCH_FORWARD(void, glTexImage2D, (GLenum t, GLint l, GLint i, GLsizei w, GLsizei h, GLint b, GLenum f, GLenum y, const GLvoid* p), (t, l, i, w, h, b, f, y, p))
TETMARCH_FORWARD(void, glTexParameterf, (GLenum t, GLenum n, GLfloat p), (t, n, p))
TETMARCH_FORWARD(void, glTexParameterfv, (GLenum t, GLenum n, const GLfloat* p), (t, n, p))
TETMARCH_FORWARD(void, glTexParameteri, (GLenum t, GLenum n, GLint p), (t, n, p))
TETMARCH_FORWARD(void, glTexParameteriv, (GLenum t, GLenum n, const GLint* p), (t, n, p))
TETMARCH_FORWARD(void, glTexSubImage1D, (GLenum t, GLint l, GLint x, GLsizei w, GLenum f, GLenum y, const GLvoid* p), (t, l, x, w, f, y, p))
TETMARCH_FORWARD(void, glTexSubImage2D, (GLenum t, GLint l, GLint x, GLint o, GLsizei w, GLsizei h, GLenum f, GLenum y, const GLvoid* p), (t, l, x, o, w, h, f, y, p))
TETMARCH_FORWARD(void, glViewport, (GLint x, GLint y, GLsizei w, GLsizei h), (x, y, w, h))
// clang-format on
