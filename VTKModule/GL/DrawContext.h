// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Where the passes of a frame draw, and who is told how far they are.
#ifndef TetMarchGLDrawContext_h
#define TetMarchGLDrawContext_h

#include "Caching/StageResult.h"
#include "Parallel/Progress.h"

class vtkOpenGLRenderWindow;

namespace tetmarch
{

struct DrawContext
{
  vtkOpenGLRenderWindow* Window = nullptr; // its context is current
  Progress Report;                         // is asked between tiles whether to go on
};

} // namespace tetmarch

#endif
