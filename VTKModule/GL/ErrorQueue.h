// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The queue in which the GL keeps errors until somebody asks.
#ifndef TetMarchGLErrorQueue_h
#define TetMarchGLErrorQueue_h

#include "vtkOpenGLRenderUtilities.h"
#include "vtkTextureObject.h"

namespace tetmarch
{

/** Remove the errors that others caused. A lost context reports one for ever. */
inline void clearErrors()
{
  for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i)
  {
  }
}

/** Whether the GL had room for a texture that was just made. A VTK that is built to report errors
 * has already taken the error from the queue; then the texture has no size. */
inline bool hasRoom(vtkTextureObject* texture)
{
  const bool sound = glGetError() == GL_NO_ERROR;
  int width = 0;
  texture->Activate();
  glGetTexLevelParameteriv(texture->GetTarget(), 0, GL_TEXTURE_WIDTH, &width);
  texture->Deactivate();
  return sound && width == static_cast<int>(texture->GetWidth());
}

} // namespace tetmarch

#endif
