// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether the GPU's fused multiply-add is one.
#ifndef TetMarchGLFmaProbe_h
#define TetMarchGLFmaProbe_h

class vtkOpenGLRenderWindow;

namespace tetmarch
{

/**
 * True if shaders may say fma (GL_ARB_gpu_shader5) and a drawn pixel shows that it rounds once.
 * Asks the GL, so keep the answer as long as the context lives.
 */
bool hasFusedMultiplyAdd(vtkOpenGLRenderWindow* window);

} // namespace tetmarch

#endif
