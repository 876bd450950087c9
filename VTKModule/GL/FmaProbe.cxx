// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/FmaProbe.h"

#include "GL/Driver.h"
#include "GL/FloatTarget.h"
#include "GL/ShaderDraw.h"
#include "GL/StateScope.h"

#include "vtkOpenGLRenderUtilities.h"
#include "vtkShaderProgram.h"

namespace tetmarch
{

bool hasFusedMultiplyAdd(vtkOpenGLRenderWindow* window)
{
  if (!hasExtension("GL_ARB_gpu_shader5"))
  {
    return false;
  }
  FloatTarget target;
  ShaderDraw draw;
  std::string error;
  float rest = 0;
  {
    StateScope state(window);
    error = target.bind(window, 1, 1, 1);
    vtkShaderProgram* program = error.empty() ? draw.use(window, "passes/full_view.vert.glsl",
                                                  "passes/fma_probe.frag.glsl", {}, error)
                                              : nullptr;
    if (program)
    {
      state->vtkglViewport(0, 0, 1, 1);
      state->vtkglDisable(GL_SCISSOR_TEST);
      state->vtkglDisable(GL_DEPTH_TEST);
      state->vtkglDisable(GL_BLEND);
      state->vtkglDisable(GL_CULL_FACE);
      state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
      program->SetUniformf("onePlus", 1.0f + 1.0f / 4096.0f);
      draw.drawTriangles(1);
      rest = target.read(window, 0)[0];
    }
  }
  draw.release();
  target.release(window);
  return rest == 1.0f / 16777216.0f;
}

} // namespace tetmarch
