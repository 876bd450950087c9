// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/ThicknessBinding.h"

#include "GL/Uniforms.h"
#include "View/View.h"

namespace tetmarch
{

void bindThickness(vtkShaderProgram* program, const View& view)
{
  setUniform(program, "thicknessMatrix", view.ThicknessMatrix);
}

} // namespace tetmarch
