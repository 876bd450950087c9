// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/BoundaryViewPass.h"

#include "GL/PixelRays.h"
#include "GL/StateScope.h"
#include "GL/TileCorners.h"
#include "GL/VolumeTextures.h"

#include "vtkOpenGLRenderUtilities.h"

namespace tetmarch
{

StageResult BoundaryViewPass::draw(
  const DrawContext& context, const MarchInputs& inputs, BoundaryView what)
{
  vtkOpenGLRenderWindow* window = context.Window;
  return drawInTiles(context, { inputs.Area, inputs.MostSecondsPerDraw, inputs.Content },
    this->Tiles,
    [&](const Viewport& tile)
    {
      // The shader compares depths along the rays, as the march does.
      const ReplaceScope state(window);
      std::string error;
      vtkShaderProgram* program = this->Draw.use(window, "passes/tile.vert.glsl",
        fileOf(VolumePass::BoundaryView), inputs.Key.defines(), error);
      if (!program)
      {
        return error;
      }
      inputs.Volume->bind(program, inputs.Key);
      bindPixelRays(program, inputs, inputs.Area);
      program->SetUniformi("showsCoordinates", what == BoundaryView::Coordinates ? 1 : 0);
      drawCorners(program, this->Draw, inputs.Area, tile);
      unbindPixelRays(inputs);
      inputs.Volume->unbind();
      return error;
    });
}

} // namespace tetmarch
