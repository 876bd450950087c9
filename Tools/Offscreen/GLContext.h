// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A GL context of the core profile, at least 3.2, that VTK's framebuffer objects can live in. The
 * surface it is bound to is only there because the interfaces ask for one; nothing is drawn to it.
 */
#ifndef tetmarch_GLContext_h
#define tetmarch_GLContext_h

#include <memory>
#include <string>

namespace tetmarch
{

class GLContext
{
public:
  GLContext() = default;
  GLContext(const GLContext&) = delete;
  GLContext& operator=(const GLContext&) = delete;
  virtual ~GLContext() = default; // leaves no context current if this one was

  virtual const char* GetBackendName() const = 0;
  virtual bool MakeCurrent() = 0;
  virtual bool IsCurrent() const = 0;
};

/// Versions to ask for, best first; 3.2 is what VTK needs.
constexpr int GLVersions[][2] = { { 4, 5 }, { 4, 1 }, { 3, 3 }, { 3, 2 } };

///@{
/**
 * Null on failure, with the reason in error.
 */
std::unique_ptr<GLContext> MakeEGLContext(std::string& error);
std::unique_ptr<GLContext> MakeOSMesaContext(std::string& error);
///@}

/**
 * By TETMARCH_GL, see OffscreenWindow.h. The first success binds the process to its backend.
 */
std::unique_ptr<GLContext> MakeGLContext(std::string& error);

} // namespace tetmarch

#endif
