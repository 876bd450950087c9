// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// How thick the volume is along a direction, as a uniform.
#ifndef TetMarchGLThicknessBinding_h
#define TetMarchGLThicknessBinding_h

class vtkShaderProgram;

namespace tetmarch
{

struct View;

/** What Shaders/march/thickness_buffers.glsl declares. */
void bindThickness(vtkShaderProgram* program, const View& view);

} // namespace tetmarch

#endif
