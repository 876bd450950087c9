// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/PictureApart.h"

#include "GL/FullViewDraw.h"
#include "GL/StateScope.h"

#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{

Viewport coarseArea(const Viewport& area, double sampleDistance)
{
  const auto fewer = [&](int pixels)
  { return std::max(1, static_cast<int>(std::lround(pixels / sampleDistance))); };
  return { 0, 0, fewer(area.Width), fewer(area.Height) };
}

StageResult PictureApart::draw(
  const DrawContext& context, const Viewport& area, MarchPass& march, const MarchInputs& inputs)
{
  vtkOpenGLRenderWindow* window = context.Window;
  const bool sameSize = inputs.Area.Width == area.Width && inputs.Area.Height == area.Height;
  const bool adaptive = inputs.PixelTolerance > 0;
  const bool enlarged = !inputs.ByCompute || !sameSize;
  StageResult result;
  if (adaptive)
  {
    this->Target.release(window);
    result = this->Adaptive.march(context, march, inputs, !sameSize);
  }
  else
  {
    this->Adaptive.release(window);
    result = this->marchWhole(
      context, march, inputs, enlarged ? TargetFormat::Share16 : TargetFormat::Float32);
  }
  this->Draws = adaptive ? this->Adaptive.numberOfDraws() : this->Tiles.numberOfTiles();
  return result.then(
    [&]
    {
      return StageResult{ adaptive ? this->blendAdaptive(window, area, sameSize)
                                   : this->blend(window, area, this->Target.color(0), enlarged) };
    });
}

std::string PictureApart::blendAdaptive(
  vtkOpenGLRenderWindow* window, const Viewport& area, bool sameSize)
{
  if (sameSize)
  {
    return this->Adaptive.blend(window, area);
  }
  const std::string error = this->Adaptive.makePicture(window);
  return error.empty() ? this->blend(window, area, this->Adaptive.picture(), true) : error;
}

// One ray for each pixel of the inputs' area.
StageResult PictureApart::marchWhole(
  const DrawContext& context, MarchPass& march, const MarchInputs& inputs, TargetFormat format)
{
  const StateScope state(context.Window);
  StageResult result{ this->Target.bind(
    context.Window, inputs.Area.Width, inputs.Area.Height, 1, format) };
  return result.then([&] { return march.drawApart(context, this->Target, inputs, this->Tiles); });
}

std::string PictureApart::show(vtkOpenGLRenderWindow* window, const Viewport& area, int width,
  int height, const std::vector<float>& pixels)
{
  if (!this->Shown.upload(window, width, height, 4, pixels))
  {
    this->release(window);
    return "The GPU has no room for a picture of " + std::to_string(width) + " x " +
           std::to_string(height) + " pixels. Close what else uses it, or make the window smaller.";
  }
  const std::string error =
    this->blend(window, area, this->Shown.texture(), width != area.Width || height != area.Height);
  return error.empty() ? this->drawDepth(window, area, this->Shown.texture()) : error;
}

std::string PictureApart::drawDepth(
  vtkOpenGLRenderWindow* window, const Viewport& area, vtkTextureObject* picture)
{
  StateScope state(window);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LESS);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDisable(GL_CULL_FACE);
  return this->drawOver(window, area, picture, "passes/picture_depth.frag.glsl");
}

std::string PictureApart::blend(
  vtkOpenGLRenderWindow* window, const Viewport& area, vtkTextureObject* picture, bool enlarged)
{
  StateScope state(window);
  blendPremultiplied(state);
  const int filter = enlarged ? vtkTextureObject::Linear : vtkTextureObject::Nearest;
  picture->SetMinificationFilter(filter);
  picture->SetMagnificationFilter(filter);
  picture->SetWrapS(vtkTextureObject::ClampToEdge);
  picture->SetWrapT(vtkTextureObject::ClampToEdge);
  return this->drawOver(window, area, picture, "passes/enlarge.frag.glsl");
}

std::string PictureApart::drawOver(vtkOpenGLRenderWindow* window, const Viewport& area,
  vtkTextureObject* picture, const char* shader)
{
  const std::array<float, 4> viewport = area.asFloats();
  return drawFullView(this->Draw, window, shader, { { "pictureTexture", picture } },
    [&](vtkShaderProgram* program) { program->SetUniform4f("viewport", viewport.data()); });
}

void PictureApart::release(vtkWindow* window)
{
  this->Draw.release();
  this->Target.release(window);
  this->Adaptive.release(window);
  this->Shown.release(window);
}

} // namespace tetmarch
