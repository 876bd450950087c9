// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What Shaders/cuts/clipping_buffers.glsl reads.
#ifndef TetMarchGLClippingBinding_h
#define TetMarchGLClippingBinding_h

class vtkShaderProgram;

namespace tetmarch
{

struct Clipping;
struct VariantKey;

void bindClipping(vtkShaderProgram* program, const Clipping& clipping, const VariantKey& key);

} // namespace tetmarch

#endif
