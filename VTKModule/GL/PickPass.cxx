// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/PickPass.h"

#include "Frame/FrameStages.h"
#include "GL/BlendBinding.h"
#include "GL/ClippingBinding.h"
#include "GL/EffectTextures.h"
#include "GL/PixelRays.h"
#include "GL/StateScope.h"
#include "GL/TableTextures.h"
#include "GL/ThicknessBinding.h"
#include "GL/TileCorners.h"
#include "GL/VolumeTextures.h"

#include "vtkOpenGLRenderUtilities.h"

namespace tetmarch
{

StageResult PickPass::pick(const DrawContext& context, const MarchInputs& inputs,
  const Viewport& part, std::vector<PickedPoint>& points)
{
  StageResult result = this->march(context, inputs, part);
  if (result.isDone())
  {
    points = this->read(context.Window, inputs.Stages->volume());
  }
  this->Target.release(context.Window);
  this->Draw.release();
  return result;
}

StageResult PickPass::march(
  const DrawContext& context, const MarchInputs& inputs, const Viewport& part)
{
  vtkOpenGLRenderWindow* window = context.Window;
  const TargetScope state(window, part.Width, part.Height);
  const std::string error = this->Target.bind(window, part.Width, part.Height, 2);
  if (!error.empty())
  {
    return { error };
  }
  state->vtkglClearColor(0, 0, 0, 0);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
  PictureContent content = inputs.Content;
  content.Drawn = screenBoxOf(part, inputs.Area);
  return drawInTiles(context,
    { { 0, 0, part.Width, part.Height }, inputs.MostSecondsPerDraw, content }, this->Tiles,
    [&](const Viewport& tile) { return this->drawTile(window, inputs, part, tile); });
}

std::string PickPass::drawTile(vtkOpenGLRenderWindow* window, const MarchInputs& inputs,
  const Viewport& part, const Viewport& tile)
{
  std::string error;
  vtkShaderProgram* program = this->Draw.use(
    window, "passes/tile.vert.glsl", fileOf(VolumePass::Pick), inputs.Key.defines(), error);
  if (!program)
  {
    return error;
  }
  inputs.Volume->bind(program, inputs.Key);
  inputs.Tables->bind(program, inputs);
  bindBlending(program, inputs.Stages->blending(), inputs.Key);
  if (inputs.Key.hasGradients())
  {
    inputs.Effects->bind(program, inputs.Stages->effects().data(), inputs.Key);
  }
  // The position of the whole area relative to the corner of the part, which is that of the target.
  const Viewport& area = inputs.Area;
  bindPixelRays(program, inputs, { area.X - part.X, area.Y - part.Y, area.Width, area.Height });
  if (inputs.Key.Clipped)
  {
    bindClipping(program, inputs.Stages->cuts(), inputs.Key);
  }
  bindThickness(program, inputs.Stages->camera());
  program->SetUniformf("transmittanceLeft", static_cast<float>(inputs.Level.ErrorTolerance));
  drawCorners(program, this->Draw, { 0, 0, part.Width, part.Height }, tile);
  inputs.Volume->unbind();
  inputs.Tables->unbind();
  inputs.Effects->unbind();
  unbindPixelRays(inputs);
  return error;
}

std::vector<PickedPoint> PickPass::read(
  vtkOpenGLRenderWindow* window, const MarchedVolume& volume) const
{
  const std::vector<float> hits = this->Target.read(window, 0);
  const std::vector<float> places = this->Target.read(window, 1);
  std::vector<PickedPoint> points(hits.size() / 4);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const float* hit = &hits[4 * i];
    const float* place = &places[4 * i];
    points[i].Hit = hit[3] > 0;
    points[i].Scalar = hit[2];
    points[i].Position = { { place[0], place[1], place[2] } };
    if (points[i].Hit)
    {
      points[i].Cell =
        volume.cellOf(static_cast<std::uint32_t>(hit[0]) | static_cast<std::uint32_t>(hit[1]) << 16,
          points[i].Position);
    }
  }
  return points;
}

} // namespace tetmarch
