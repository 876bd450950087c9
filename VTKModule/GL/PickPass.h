// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Marches one ray a pixel to the point where the volume is picked.
#ifndef TetMarchGLPickPass_h
#define TetMarchGLPickPass_h

#include "GL/FloatTarget.h"
#include "GL/MarchPass.h"
#include "Picking/PickedPoint.h"

#include <vector>

namespace tetmarch
{

class MarchedVolume;

class PickPass
{
public:
  /**
   * Find the picked points of the pixels in a part of the inputs' area, rows from the bottom. The
   * key of the inputs is one ofPick(). A ray is picked where its transmittance has fallen to the
   * tolerance of the level. Only a program stays on the GPU.
   */
  StageResult pick(const DrawContext& context, const MarchInputs& inputs, const Viewport& part,
    std::vector<PickedPoint>& points);
  void release()
  {
    this->Draw.release();
    this->Tiles.forget();
  }

private:
  StageResult march(const DrawContext& context, const MarchInputs& inputs, const Viewport& part);
  std::string drawTile(vtkOpenGLRenderWindow* window, const MarchInputs& inputs,
    const Viewport& part, const Viewport& tile);
  std::vector<PickedPoint> read(vtkOpenGLRenderWindow* window, const MarchedVolume& volume) const;

  FloatTarget Target;
  ShaderDraw Draw;
  TileSchedule Tiles;
};

} // namespace tetmarch

#endif
