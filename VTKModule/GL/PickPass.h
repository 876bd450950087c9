// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Marches one ray a pixel up to where the volume is picked.
#ifndef TetMarchGLPickPass_h
#define TetMarchGLPickPass_h

#include "GL/FloatTarget.h"
#include "GL/MarchPass.h"
#include "Picking/PickedPoint.h"

#include <vector>

namespace tetmarch
{

class PickPass
{
public:
  /**
   * Of the pixels in a part of the inputs' area, rows from the bottom. The key of the inputs is one
   * ofPick(); what is left of the light at the points is the tolerance of their level. Returns an
   * empty string, or what is wrong; `stopped` becomes true if progress asked to stop between two
   * tiles. Nothing is left on the GPU but a program.
   */
  std::string pick(vtkOpenGLRenderWindow* window, const MarchInputs& inputs, const Viewport& part,
    const Progress& progress, bool& stopped, std::vector<PickedPoint>& points);
  void release() { this->Draw.release(); }

private:
  std::string march(vtkOpenGLRenderWindow* window, const MarchInputs& inputs, const Viewport& part,
    const Progress& progress, bool& stopped);
  std::string drawTile(vtkOpenGLRenderWindow* window, const MarchInputs& inputs,
    const Viewport& part, const Viewport& tile);
  std::vector<PickedPoint> read(vtkOpenGLRenderWindow* window, const MarchSource& source) const;

  FloatTarget Target;
  ShaderDraw Draw;
  TileSchedule Tiles;
};

} // namespace tetmarch

#endif
