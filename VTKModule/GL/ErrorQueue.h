// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The GL keeps errors until somebody asks.
#ifndef TetMarchGLErrorQueue_h
#define TetMarchGLErrorQueue_h

#include "vtkOpenGLRenderUtilities.h"

namespace tetmarch
{

/** Forget errors that others left; a lost context reports one for ever. */
inline void clearErrors()
{
  for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i)
  {
  }
}

} // namespace tetmarch

#endif
