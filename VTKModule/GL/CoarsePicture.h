// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Draws a picture with fewer rays than the viewport has pixels.
#ifndef TetMarchGLCoarsePicture_h
#define TetMarchGLCoarsePicture_h

#include "GL/FloatTarget.h"
#include "GL/MarchPass.h"
#include "GL/ShaderDraw.h"

namespace tetmarch
{

/** The viewport in pixels that are sampleDistance apart: at least 1 x 1, in the same corner. */
Viewport coarseArea(const Viewport& area, double sampleDistance);

class CoarsePicture
{
public:
  /**
   * March the coarse area of the inputs, and blend the picture, interpolated, over that of the
   * window. Returns an empty string, or what is wrong; `stopped` becomes true if progress asked to
   * stop, and nothing is blended then.
   */
  std::string draw(vtkOpenGLRenderWindow* window, const Viewport& area, MarchPass& march,
    const MarchInputs& inputs, const Progress& progress, bool& stopped);
  int numberOfDraws() const { return this->Tiles.numberOfTiles(); }
  std::size_t bytes() const { return this->Target.bytes(); }
  /** The next draw() may take much longer than the last. */
  void expectChange() { this->Tiles.expectChange(); }
  void release(vtkWindow* window);

private:
  std::string enlarge(vtkOpenGLRenderWindow* window, const Viewport& area);

  FloatTarget Target;
  TileSchedule Tiles;
  ShaderDraw Draw;
};

} // namespace tetmarch

#endif
