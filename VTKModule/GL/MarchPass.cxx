// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/MarchPass.h"

#include "Frame/FrameStages.h"
#include "GL/BlendBinding.h"
#include "GL/ClippingBinding.h"
#include "GL/EffectTextures.h"
#include "GL/LightBinding.h"
#include "GL/PeelHooks.h"
#include "GL/PixelRays.h"
#include "GL/ProgramCapture.h"
#include "GL/RayList.h"
#include "GL/StateScope.h"
#include "GL/TableTextures.h"
#include "GL/ThicknessBinding.h"
#include "GL/TileCorners.h"
#include "GL/Uniforms.h"
#include "GL/VolumeTextures.h"
#include "View/View.h"

#include "vtkOpenGLRenderUtilities.h"
#include "vtkTextureObject.h"

namespace tetmarch
{

namespace
{

void bindVisits(vtkShaderProgram* program, const VisitInputs& visits, const VariantKey& key)
{
  if (key.Adaptive)
  {
    program->SetUniformf("toleranceAtOnce", visits.AtOnce);
  }
  program->SetUniformi("isFirstVisit", visits.IsFirst ? 1 : 0);
  bindImage(program, "nextEntryTexture", visits.NextEntry);
  bindImage(program, "raySoFarTexture", visits.RaySoFar);
  if (key.accumulatesOpacity())
  {
    program->SetUniformi("knowsHidden", visits.KnowsHidden ? 1 : 0);
    program->SetUniformi("firstRow", visits.FirstRow);
    bindImage(program, "hiddenTexture", visits.Hidden);
  }
}

void bindSamples(vtkShaderProgram* program, const FrameStages& stages)
{
  const RaySamples& samples = stages.samples();
  const double step = samples.step(stages.volume().frame());
  program->SetUniformf("sampleStep", static_cast<float>(step));
  program->SetUniformf("samplesPerDepth", static_cast<float>(1 / step));
  program->SetUniform2f("sampleShift", samples.shift().data());
}

void bindDeparture(vtkShaderProgram* program, const CurvedDeparture& departure)
{
  const float values[] = { static_cast<float>(departure.Distance),
    static_cast<float>(departure.Value) };
  program->SetUniform2f("curvedDeparture", values);
}

// Everything that the march reads.
void bindInputs(vtkShaderProgram* program, const MarchInputs& inputs, const Viewport& target)
{
  const VariantKey& key = inputs.Key;
  const FrameStages& stages = *inputs.Stages;
  inputs.Volume->bind(program, inputs.Key);
  inputs.Tables->bind(program, inputs);
  bindBlending(program, stages.blending(), key);
  if (key.hasGradients() || key.hasStoredGradients())
  {
    inputs.Effects->bind(program, stages.effects().data(), key);
  }
  if (key.Shading)
  {
    bindLights(program, stages.effects().data().Lights, key);
  }
  if (key.hasVertexLight())
  {
    bindImage(program, "vertexLightTexture", inputs.VertexLight);
  }
  if (key.SampledShadows)
  {
    bindLightRays(program, stages.effects().data().Lights, key);
  }
  if (key.samplesSurfaces())
  {
    inputs.Effects->bindSurfaces(program, stages.effects().data());
  }
  if (key.SampledShadows || key.PointSampled)
  {
    inputs.Effects->bindJitter(program);
  }
  if (key.PointSampled)
  {
    bindSamples(program, stages);
  }
  if (key.CurvedError)
  {
    bindDeparture(program, stages.departure());
  }
  bindPixelRays(program, inputs, target);
  if (inputs.Peeling)
  {
    inputs.Peeling->bind(program);
  }
  if (key.Clipped)
  {
    bindClipping(program, stages.cuts(), key);
  }
  bindThickness(program, stages.camera());
  if (!key.Diagnostics)
  {
    program->SetUniform2f("colorWindow", inputs.ColorWindow.data());
  }
  if (inputs.Visits)
  {
    bindVisits(program, *inputs.Visits, key);
  }
  if (inputs.List)
  {
    inputs.List->bind(program);
  }
}

void unbindInputs(const MarchInputs& inputs)
{
  inputs.Volume->unbind();
  inputs.Tables->unbind();
  if (inputs.Effects)
  {
    inputs.Effects->unbind();
  }
  if (inputs.VertexLight)
  {
    inputs.VertexLight->Deactivate();
  }
  unbindPixelRays(inputs);
  if (inputs.Visits)
  {
    inputs.Visits->NextEntry->Deactivate();
    inputs.Visits->RaySoFar->Deactivate();
    inputs.Visits->Hidden->Deactivate();
  }
  if (inputs.List)
  {
    inputs.List->unbind();
  }
}

} // namespace

void blendPremultiplied(const StateScope& state)
{
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglDisable(GL_CULL_FACE);
}

StageResult MarchPass::draw(
  const DrawContext& context, const MarchInputs& inputs, TileSchedule& tiles)
{
  return drawInTiles(context, { inputs.Area, inputs.MostSecondsPerDraw, inputs.Content }, tiles,
    [&](const Viewport& tile)
    {
      StateScope state(context.Window);
      if (inputs.Key.Peeled)
      {
        state->vtkglDisable(GL_DEPTH_TEST);
        state->vtkglDisable(GL_CULL_FACE);
      }
      else
      {
        blendPremultiplied(state);
      }
      return this->drawTile(context.Window, inputs, inputs.Area, tile);
    });
}

StageResult MarchPass::drawApart(const DrawContext& context, const FloatTarget& images,
  const MarchInputs& inputs, TileSchedule& tiles)
{
  vtkOpenGLRenderWindow* window = context.Window;
  const Viewport target{ 0, 0, inputs.Area.Width, inputs.Area.Height };
  const TargetScope state(window, target.Width, target.Height);
  if (inputs.Visits)
  {
    state->vtkglEnable(GL_SCISSOR_TEST);
    const Viewport& part = inputs.Visits->Part;
    state->vtkglScissor(part.X, part.Y, part.Width, part.Height);
  }
  state->vtkglClearColor(0, 0, 0, 0);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
  return drawInTiles(context, { target, inputs.MostSecondsPerDraw, inputs.Content }, tiles,
    [&](const Viewport& tile)
    {
      return inputs.ByCompute ? this->dispatchTile(window, inputs, images, tile)
                              : this->drawTile(window, inputs, target, tile);
    });
}

StageResult MarchPass::drawListed(
  const DrawContext& context, FloatTarget& target, const MarchInputs& inputs, TileSchedule& tiles)
{
  vtkOpenGLRenderWindow* window = context.Window;
  const TargetScope state(window, target.width(), target.height());
  const std::string error = target.bindAgain(window);
  return StageResult{ error }.then(
    [&]
    {
      return drawInTiles(context,
        { inputs.List->image(), inputs.MostSecondsPerDraw, inputs.Content }, tiles,
        [&](const Viewport& tile)
        {
          return inputs.ByCompute ? this->dispatchTile(window, inputs, target, tile)
                                  : this->drawListedTile(window, inputs, target, tile);
        });
    });
}

vtkShaderProgram* MarchPass::use(
  vtkOpenGLRenderWindow* window, const MarchInputs& inputs, std::string& error)
{
  return this->Draw.use(window, "passes/tile.vert.glsl",
    fileOf(inputs.Visits ? VolumePass::Visits : VolumePass::March), inputs.Key.defines(), error,
    inputs.Peeling);
}

std::string MarchPass::capture(
  vtkOpenGLRenderWindow* window, const MarchInputs& inputs, CapturedProgram& captured)
{
  std::string error;
  if (vtkShaderProgram* program = this->use(window, inputs, error))
  {
    bindInputs(program, inputs, inputs.Area);
    error = captured.add(static_cast<unsigned int>(program->GetHandle()));
    unbindInputs(inputs);
  }
  return error;
}

std::string MarchPass::drawTile(vtkOpenGLRenderWindow* window, const MarchInputs& inputs,
  const Viewport& target, const Viewport& tile)
{
  std::string error;
  vtkShaderProgram* program = this->use(window, inputs, error);
  if (!program)
  {
    return error;
  }
  bindInputs(program, inputs, target);
  // llvmpipe takes 60 % of the time of a short ray for one that misses the mesh.
  const Viewport entered = overlapOf(tile, inputs.Volume->enteredPart(inputs.Key, target));
  const bool any = entered.Width > 0 && entered.Height > 0;
  // A frame without entries holds the same GL objects as any other.
  drawCorners(program, this->Draw, target, any ? entered : tile);
  unbindInputs(inputs);
  return {};
}

std::string MarchPass::drawListedTile(vtkOpenGLRenderWindow* window, const MarchInputs& inputs,
  const FloatTarget& target, const Viewport& tile)
{
  std::string error;
  vtkShaderProgram* program = this->Draw.use(
    window, "passes/listed.vert.glsl", fileOf(VolumePass::Listed), inputs.Key.defines(), error);
  if (!program)
  {
    return error;
  }
  bindInputs(program, inputs, { 0, 0, inputs.Area.Width, inputs.Area.Height });
  program->SetUniformf("rowsOfImage", static_cast<float>(target.height()));
  drawRectangle(program, this->Draw, { 0, 0, target.width(), target.height() }, tile);
  unbindInputs(inputs);
  return {};
}

std::string MarchPass::dispatchTile(vtkOpenGLRenderWindow* window, const MarchInputs& inputs,
  const FloatTarget& images, const Viewport& tile)
{
  std::string error;
  vtkShaderProgram* program = this->Dispatch.use(window,
    fileOf(inputs.List ? VolumePass::ListedByCompute : VolumePass::MarchByCompute),
    inputs.Key.defines(), error);
  if (!program)
  {
    return error;
  }
  bindInputs(program, inputs, { 0, 0, inputs.Area.Width, inputs.Area.Height });
  this->Dispatch.dispatch(program, images, tile);
  unbindInputs(inputs);
  return {};
}

void MarchPass::release()
{
  this->Draw.release();
  this->Dispatch.release();
}

} // namespace tetmarch
