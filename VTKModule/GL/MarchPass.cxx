// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/MarchPass.h"

#include "GL/MeshTextures.h"
#include "GL/StateScope.h"
#include "GL/TableTextures.h"
#include "GL/Uniforms.h"
#include "Scene/View.h"

#include "vtkOpenGLRenderUtilities.h"
#include "vtkTextureObject.h"

namespace tetmarch
{
namespace
{

void bindImage(vtkShaderProgram* program, const char* sampler, vtkTextureObject* texture)
{
  texture->Activate();
  program->SetUniformi(sampler, texture->GetTextureUnit());
}

} // namespace

std::string MarchPass::draw(vtkOpenGLRenderWindow* window, const MarchInputs& inputs)
{
  StateScope state(window);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglDisable(GL_CULL_FACE);
  return this->drawVariant(window, inputs, inputs.Area);
}

std::string MarchPass::drawDiagnostics(vtkOpenGLRenderWindow* window, MarchInputs inputs)
{
  StateScope state(window);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglViewport(0, 0, inputs.Area.Width, inputs.Area.Height);
  state->vtkglClearColor(0, 0, 0, 0);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
  inputs.Key.Diagnostics = true;
  return this->drawVariant(window, inputs, { 0, 0, inputs.Area.Width, inputs.Area.Height });
}

std::string MarchPass::drawVariant(
  vtkOpenGLRenderWindow* window, const MarchInputs& inputs, const Viewport& target)
{
  std::string error;
  vtkShaderProgram* program =
    this->Draw.use(window, "full_view.vert.glsl", "march.frag.glsl", inputs.Key.defines(), error);
  if (!program)
  {
    return error;
  }
  const View& view = *inputs.Camera;
  inputs.Mesh->bind(program, inputs.Key);
  inputs.Tables->bind(program, *inputs.Table, inputs.Range, inputs.Level, inputs.Key);
  const std::array<float, 4> area = target.asFloats();
  program->SetUniform4f("viewport", area.data());
  setUniform(program, "eye", view.Eye);
  setUniform(program, "lengthMatrix", view.LengthMatrix);
  if (inputs.Key.OpaqueDepth || !inputs.Key.RasterEntry)
  {
    setUniform(program, "clipToNormalized", view.ClipToNormalized);
  }
  if (inputs.Key.RasterEntry)
  {
    bindImage(program, "entryTexture", inputs.Entries);
  }
  if (inputs.Key.OpaqueDepth)
  {
    bindImage(program, "opaqueDepthTexture", inputs.Depths);
    program->SetUniformi("cutsFarPlane", view.CutsFarPlane ? 1 : 0);
  }

  this->Draw.drawTriangles(1);

  inputs.Mesh->unbind();
  inputs.Tables->unbind();
  if (inputs.Entries)
  {
    inputs.Entries->Deactivate();
  }
  if (inputs.Depths)
  {
    inputs.Depths->Deactivate();
  }
  return {};
}

void MarchPass::release() { this->Draw.release(); }

} // namespace tetmarch
