// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/VertexLightPass.h"

#include "GL/EffectTextures.h"
#include "GL/LightBinding.h"
#include "GL/MeshTextures.h"
#include "GL/StateScope.h"
#include "GL/TableTextures.h"
#include "GL/TileCorners.h"
#include "GL/Uniforms.h"
#include "Scene/View.h"

#include "vtkOpenGLRenderUtilities.h"

namespace tetmarch
{

std::string VertexLightPass::update(vtkOpenGLRenderWindow* window, const MarchInputs& inputs,
  std::size_t vertices, const Fingerprint& version, const Progress& progress, bool& stopped)
{
  if (version == this->Version)
  {
    return {};
  }
  StageRecorder recorder(this->Record);
  this->Version.clear();
  const int rows = static_cast<int>((vertices + RowLength - 1) / RowLength);
  const Viewport target{ 0, 0, RowLength, rows };
  MarchInputs light = inputs;
  light.Key = inputs.Key.ofVertexLight();
  light.Level = LightAccuracy;
  StateScope state(window);
  std::string error = this->Target.bind(window, RowLength, rows, 1, false, TargetFormat::Share16);
  if (!error.empty())
  {
    return error;
  }
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglViewport(0, 0, RowLength, rows);
  error = drawInTiles(window, target, inputs.MostSecondsPerDraw, this->Tiles, progress, stopped,
    [&](const Viewport& tile)
    { return this->drawTile(window, light, target, tile, vertices, !inputs.Key.SampledShadows); });
  glFinish(); // what it took is told
  if (error.empty() && !stopped)
  {
    this->Version = version;
  }
  return error;
}

std::string VertexLightPass::drawTile(vtkOpenGLRenderWindow* window, const MarchInputs& inputs,
  const Viewport& target, const Viewport& tile, std::size_t vertices, bool toLights)
{
  std::string error;
  vtkShaderProgram* program =
    this->Draw.use(window, "tile.vert.glsl", "vertex_light.frag.glsl", inputs.Key.defines(), error);
  if (!program)
  {
    return error;
  }
  inputs.Mesh->bind(program, inputs.Key);
  inputs.Tables->bind(program, *inputs.Table, inputs.Range, inputs.Level, inputs.Key);
  inputs.Effects->bind(program, *inputs.EffectValues, inputs.Key);
  inputs.Effects->bindStarts(program);
  if (inputs.Key.OpaqueShadows)
  {
    inputs.Effects->bindOpaqueShadows(program);
  }
  bindVertexRays(program, inputs.EffectValues->Lights, toLights);
  setUniform(program, "lengthMatrix", inputs.Camera->LengthMatrix);
  program->SetUniformi("vertexCount", static_cast<int>(vertices));
  drawCorners(program, this->Draw, target, tile);
  inputs.Mesh->unbind();
  inputs.Tables->unbind();
  inputs.Effects->unbind();
  return {};
}

void VertexLightPass::release(vtkWindow* window)
{
  this->Draw.release();
  this->Target.release(window);
  this->Tiles.expectChange();
  this->Version.clear();
}

} // namespace tetmarch
