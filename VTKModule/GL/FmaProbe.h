// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether the GPU's fused multiply-add rounds once.
#ifndef TetMarchGLFmaProbe_h
#define TetMarchGLFmaProbe_h

class vtkOpenGLRenderWindow;

namespace tetmarch
{

/** True if shaders may use fma (GL_ARB_gpu_shader5) and a pixel drawn by it shows that it rounds
 * once. Draws and reads back, so keep the answer as long as the context lives. */
bool hasFusedMultiplyAdd(vtkOpenGLRenderWindow* window);

} // namespace tetmarch

#endif
