// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A picture that is marched into a target of its own, and then blended over the window's: with
// fewer rays than the viewport has pixels, or by a compute shader.
#ifndef TetMarchGLPictureApart_h
#define TetMarchGLPictureApart_h

#include "GL/FloatTarget.h"
#include "GL/MarchPass.h"
#include "GL/ShaderDraw.h"

namespace tetmarch
{

/** The viewport in pixels that are sampleDistance apart: at least 1 x 1, in the same corner. */
Viewport coarseArea(const Viewport& area, double sampleDistance);

class PictureApart
{
public:
  /**
   * March the area of the inputs, and blend the picture over that of the window; interpolated if
   * the viewport, `area`, is larger. Returns an empty string, or what is wrong; `stopped` becomes
   * true if progress asked to stop, and nothing is blended then.
   */
  std::string draw(vtkOpenGLRenderWindow* window, const Viewport& area, MarchPass& march,
    const MarchInputs& inputs, const Progress& progress, bool& stopped);
  int numberOfDraws() const { return this->Tiles.numberOfTiles(); }
  std::size_t bytes() const { return this->Target.bytes(); }
  /** The next draw() may take much longer than the last. */
  void expectChange() { this->Tiles.expectChange(); }
  void release(vtkWindow* window);

private:
  std::string blend(vtkOpenGLRenderWindow* window, const Viewport& area, bool enlarged);

  FloatTarget Target;
  TileSchedule Tiles;
  ShaderDraw Draw;
};

} // namespace tetmarch

#endif
