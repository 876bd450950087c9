// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Draws what a hardware selector reads.
#ifndef TetMarchGLSelectionPass_h
#define TetMarchGLSelectionPass_h

#include "GL/ShaderDraw.h"
#include "GL/Viewport.h"

#include <vector>

namespace tetmarch
{

class SelectionPass
{
public:
  /**
   * Four numbers a pixel of a part of the viewport, rows from the bottom: a colour, and the depth
   * that it is drawn at, if nothing nearer is there; 1: it isn't drawn. Returns an empty string, or
   * what is wrong.
   */
  std::string draw(vtkOpenGLRenderWindow* window, const Viewport& viewport, const Viewport& part,
    std::vector<float> texels);
  void release() { this->Draw.release(); }

private:
  ShaderDraw Draw;
};

} // namespace tetmarch

#endif
