// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/PictureApart.h"

#include "GL/StateScope.h"
#include "GL/Uniforms.h"

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

std::string PictureApart::draw(vtkOpenGLRenderWindow* window, const Viewport& area,
  MarchPass& march, const MarchInputs& inputs, const Progress& progress, bool& stopped)
{
  const bool sameSize = inputs.Area.Width == area.Width && inputs.Area.Height == area.Height;
  const bool enlarged = !inputs.ByCompute || !sameSize;
  std::string error;
  {
    StateScope state(window);
    error = this->Target.bind(window, inputs.Area.Width, inputs.Area.Height, 1,
      enlarged ? TargetFormat::Share16 : TargetFormat::Float32);
    if (error.empty())
    {
      error = march.drawApart(window, this->Target, inputs, this->Tiles, progress, stopped);
    }
  }
  return error.empty() && !stopped ? this->blend(window, area, enlarged) : error;
}

std::string PictureApart::blend(vtkOpenGLRenderWindow* window, const Viewport& area, bool enlarged)
{
  StateScope state(window);
  std::string error;
  vtkShaderProgram* program =
    this->Draw.use(window, "passes/full_view.vert.glsl", "passes/enlarge.frag.glsl", {}, error);
  if (!program)
  {
    return error;
  }
  blendPremultiplied(state);
  vtkTextureObject* picture = this->Target.color(0);
  const int filter = enlarged ? vtkTextureObject::Linear : vtkTextureObject::Nearest;
  picture->SetMinificationFilter(filter);
  picture->SetMagnificationFilter(filter);
  picture->SetWrapS(vtkTextureObject::ClampToEdge);
  picture->SetWrapT(vtkTextureObject::ClampToEdge);
  const std::array<float, 4> viewport = area.asFloats();
  program->SetUniform4f("viewport", viewport.data());
  bindImage(program, "pictureTexture", picture);
  this->Draw.drawTriangles(1);
  picture->Deactivate();
  return {};
}

void PictureApart::release(vtkWindow* window)
{
  this->Draw.release();
  this->Target.release(window);
}

} // namespace tetmarch
