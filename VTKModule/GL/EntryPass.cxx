// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/EntryPass.h"

#include "GL/MeshTextures.h"
#include "GL/StateScope.h"
#include "GL/Uniforms.h"
#include "Mesh/TetMesh.h"
#include "Rays/FittedDepths.h"
#include "Rays/View.h"

#include "vtkOpenGLRenderUtilities.h"

namespace tetmarch
{
namespace
{

// Clamps depths to 0..1 while it lives. VTK keeps no record of this state.
class DepthClamp
{
public:
  DepthClamp()
    : WasOn(glIsEnabled(GL_DEPTH_CLAMP) == GL_TRUE)
  {
    glEnable(GL_DEPTH_CLAMP);
  }
  ~DepthClamp()
  {
    if (!this->WasOn)
    {
      glDisable(GL_DEPTH_CLAMP);
    }
  }
  DepthClamp(const DepthClamp&) = delete;
  DepthClamp& operator=(const DepthClamp&) = delete;

private:
  bool WasOn;
};

} // namespace

std::string EntryPass::draw(vtkOpenGLRenderWindow* window, const Viewport& viewport,
  const Viewport& part, const View& view, const TetMesh& mesh, MeshTextures& textures)
{
  StateScope state(window);
  std::string error = this->Target.bind(window, viewport.Width, viewport.Height, 1, true);
  if (!error.empty())
  {
    return error;
  }
  state->vtkglViewport(0, 0, viewport.Width, viewport.Height);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(part.X - viewport.X, part.Y - viewport.Y, part.Width, part.Height);
  state->vtkglDisable(GL_BLEND);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglEnable(GL_CULL_FACE);
  state->vtkglCullFace(view.Mirrored ? GL_FRONT : GL_BACK);
  state->vtkglClearColor(-1, 0, 0, 0);
  state->vtkglClearDepth(1.0);
  state->vtkglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

  // The interpolated depth of a needle may leave 0..1 at a pixel that only its rounded image
  // covers.
  const DepthClamp clamp;
  vtkShaderProgram* program =
    this->Draw.use(window, "passes/entry.vert.glsl", "passes/entry.frag.glsl", {}, error);
  if (program)
  {
    textures.bindBoundary(program);
    setUniform(program, "normalizedToClip", fittedDepths(view, mesh.Frame));
    this->Draw.drawTriangles(static_cast<int>(mesh.BoundaryFaces.size()));
    textures.unbind();
  }
  return error;
}

void EntryPass::release(vtkWindow* window)
{
  this->Draw.release();
  this->Target.release(window);
}

} // namespace tetmarch
