// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What a renderer draws, in float where the mapper can
 */
#ifndef tetmarch_bench_FloatPicture_h
#define tetmarch_bench_FloatPicture_h

#include "Images.h"

#include "vtkFramebufferPass.h"
#include "vtkNew.h"

class vtkRenderWindow;
class vtkRenderer;

namespace tetmarch::bench
{
/// As long as it lives, the renderer draws into a framebuffer of floats.
class FloatFramebuffer
{
public:
  FloatFramebuffer(vtkRenderWindow* window, vtkRenderer* renderer);
  ~FloatFramebuffer();
  FloatFramebuffer(const FloatFramebuffer&) = delete;
  FloatFramebuffer& operator=(const FloatFramebuffer&) = delete;

  /// What was drawn last. Throws Failure if it can't be read.
  testing::Image read() const;

private:
  vtkRenderWindow* Window;
  vtkRenderer* Renderer;
  vtkNew<vtkFramebufferPass> Pass;
};

/// The alpha channel of each is what the mapper left there; mappers differ in that.
struct FloatPictures
{
  testing::Image OnBlack;
  testing::Image OnWhite;
};

/// Draws two frames into a framebuffer of floats; the renderer is afterwards as it was, but for a
/// black background. Mappers that make an image of bytes (VTK's ray casters on the CPU) have its
/// steps in it.
FloatPictures drawInFloat(vtkRenderWindow* window, vtkRenderer* renderer);
/// For mappers that draw into the window whatever framebuffer is bound (VTK 9.1's projected
/// tetrahedra): what its bytes are.
FloatPictures drawInBytes(vtkRenderWindow* window, vtkRenderer* renderer);
} // namespace tetmarch::bench

#endif
