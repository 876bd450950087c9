// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/CoarsePicture.h"

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

std::string CoarsePicture::draw(vtkOpenGLRenderWindow* window, const Viewport& area,
  MarchPass& march, const MarchInputs& inputs, const Progress& progress, bool& stopped)
{
  std::string error;
  {
    StateScope state(window);
    error =
      this->Target.bind(window, inputs.Area.Width, inputs.Area.Height, 1, TargetFormat::Share16);
    if (error.empty())
    {
      error = march.drawApart(window, inputs, this->Tiles, progress, stopped);
    }
  }
  return error.empty() && !stopped ? this->enlarge(window, area) : error;
}

std::string CoarsePicture::enlarge(vtkOpenGLRenderWindow* window, const Viewport& area)
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
  picture->SetMinificationFilter(vtkTextureObject::Linear);
  picture->SetMagnificationFilter(vtkTextureObject::Linear);
  picture->SetWrapS(vtkTextureObject::ClampToEdge);
  picture->SetWrapT(vtkTextureObject::ClampToEdge);
  const std::array<float, 4> viewport = area.asFloats();
  program->SetUniform4f("viewport", viewport.data());
  bindImage(program, "pictureTexture", picture);
  this->Draw.drawTriangles(1);
  picture->Deactivate();
  return {};
}

void CoarsePicture::release(vtkWindow* window)
{
  this->Draw.release();
  this->Target.release(window);
}

} // namespace tetmarch
