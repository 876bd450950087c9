// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Draws the colours that a hardware selector reads.
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
   * Draw a part of the viewport. The texels have four numbers a pixel, rows from the bottom: a
   * colour, and the depth at which it is drawn if nothing nearer is there; pixels of depth 1 are
   * not drawn. Returns an empty string, or what is wrong.
   */
  std::string draw(vtkOpenGLRenderWindow* window, const Viewport& viewport, const Viewport& part,
    std::vector<float> texels);
  void release() { this->Draw.release(); }

private:
  ShaderDraw Draw;
};

} // namespace tetmarch

#endif
