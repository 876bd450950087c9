// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Draws the boundary faces at which rays enter the volume, without a march.
#ifndef TetMarchGLBoundaryViewPass_h
#define TetMarchGLBoundaryViewPass_h

#include "Diagnostics/BoundaryView.h"
#include "GL/MarchPass.h"

namespace tetmarch
{

class BoundaryViewPass
{
public:
  /**
   * Draw opaque colours. Pixels whose ray meets nothing, or opaque geometry first, stay as they
   * are. The key of the inputs is one ofEntries().
   */
  StageResult draw(const DrawContext& context, const MarchInputs& inputs, BoundaryView what);
  /** Nothing is known of how long the next frame takes. */
  void forgetTimes() { this->Tiles.forget(); }
  void release() { this->Draw.release(); }
  int numberOfDraws() const { return this->Tiles.numberOfTiles(); }

private:
  ShaderDraw Draw;
  TileSchedule Tiles;
};

} // namespace tetmarch

#endif
