// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/SelectionPass.h"

#include "GL/ErrorQueue.h"
#include "GL/StateScope.h"
#include "GL/TileCorners.h"
#include "GL/Uniforms.h"

#include "vtkTextureObject.h"

namespace tetmarch
{

std::string SelectionPass::draw(vtkOpenGLRenderWindow* window, const Viewport& viewport,
  const Viewport& part, std::vector<float> texels)
{
  StateScope state(window);
  std::string error;
  vtkShaderProgram* program =
    this->Draw.use(window, "passes/tile.vert.glsl", "passes/selection.frag.glsl", {}, error);
  if (!program)
  {
    return error;
  }
  clearErrors();
  vtkNew<vtkTextureObject> texture;
  texture->SetContext(window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  texture->Create2DFromRaw(static_cast<unsigned int>(part.Width),
    static_cast<unsigned int>(part.Height), 4, VTK_FLOAT, texels.data());
  if (!hasRoom(texture))
  {
    texture->ReleaseGraphicsResources(window);
    return "The GPU has no room for a float texture of " + std::to_string(part.Width) + " x " +
           std::to_string(part.Height) +
           " pixels. Close what else uses it, or select a smaller area.";
  }
  state->vtkglDisable(GL_BLEND);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  const std::array<float, 2> corner{ { static_cast<float>(part.X), static_cast<float>(part.Y) } };
  program->SetUniform2f("corner", corner.data());
  bindImage(program, "selectionTexture", texture);
  drawCorners(program, this->Draw, viewport, part);
  texture->Deactivate();
  texture->ReleaseGraphicsResources(window);
  this->Draw.release();
  return {};
}

} // namespace tetmarch
