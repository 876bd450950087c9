// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/PixelRays.h"

#include "Frame/FrameStages.h"
#include "GL/Uniforms.h"
#include "View/View.h"

#include "vtkTextureObject.h"

namespace tetmarch
{

void bindPixelRays(vtkShaderProgram* program, const MarchInputs& inputs, const Viewport& target)
{
  const View& view = inputs.Stages->camera();
  const std::array<float, 4> area = target.asFloats();
  program->SetUniform4f("viewport", area.data());
  setUniform(program, "eye", view.Eye);
  setUniform(program, "rayPoints", inputs.RayPoints);
  if (!inputs.Key.EntryLists || inputs.Key.VisiblePart)
  {
    setUniform(program, "nearPlane", view.nearPlane());
  }
  if (inputs.Key.OpaqueDepth)
  {
    bindImage(program, "opaqueDepthTexture", inputs.Depths);
    program->SetUniform2f("depthsPerPixel", inputs.DepthsPerPixel.data());
  }
  if (inputs.Key.OpaqueDepth || inputs.Key.Peeled)
  {
    setUniform(program, "clipToNormalized", view.ClipToNormalized);
    program->SetUniformi("cutsFarPlane", view.CutsFarPlane ? 1 : 0);
  }
}

void unbindPixelRays(const MarchInputs& inputs)
{
  if (inputs.Depths)
  {
    inputs.Depths->Deactivate();
  }
}

} // namespace tetmarch
