// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A picture that is marched into a target of its own, and then blended over the window's: with
// fewer rays than the viewport has pixels, by a compute shader, or by several processes.
#ifndef TetMarchGLPictureApart_h
#define TetMarchGLPictureApart_h

#include "GL/AdaptivePicture.h"
#include "GL/FloatTarget.h"
#include "GL/MarchPass.h"
#include "GL/ShaderDraw.h"
#include "GL/UploadedImage.h"

namespace tetmarch
{

/** The viewport in pixels that are sampleDistance apart: at least 1 x 1, in the same corner. */
Viewport coarseArea(const Viewport& area, double sampleDistance);

class PictureApart
{
public:
  /**
   * March the area of the inputs, and blend the picture over that of the window; interpolated if
   * the viewport, `area`, is larger. With a PixelTolerance the picture is adaptive. Nothing is
   * blended if it is stopped.
   */
  StageResult draw(
    const DrawContext& context, const Viewport& area, MarchPass& march, const MarchInputs& inputs);
  /** Blend a picture of premultiplied colours and opacities, four floats a pixel, rows from the
   * bottom, over that of the window; interpolated if the viewport is larger. Where it isn't
   * transparent and nothing opaque is seen, it gets the depth just before the far plane. */
  std::string show(vtkOpenGLRenderWindow* window, const Viewport& area, int width, int height,
    const std::vector<float>& pixels);
  int numberOfDraws() const { return this->Draws; }
  AdaptivePicture& adaptive() { return this->Adaptive; }
  const AdaptivePicture& adaptive() const { return this->Adaptive; }
  std::size_t bytes() const
  {
    return this->Target.bytes() + this->Adaptive.bytes() + this->Shown.bytes();
  }
  /** Nothing is known of how long the next draw() takes. */
  void forgetTimes()
  {
    this->Tiles.forget();
    this->Adaptive.forgetTimes();
  }
  void release(vtkWindow* window);

private:
  StageResult marchWhole(
    const DrawContext& context, MarchPass& march, const MarchInputs& inputs, TargetFormat format);
  std::string blendAdaptive(vtkOpenGLRenderWindow* window, const Viewport& area, bool sameSize);
  std::string blend(
    vtkOpenGLRenderWindow* window, const Viewport& area, vtkTextureObject* picture, bool enlarged);
  std::string drawDepth(
    vtkOpenGLRenderWindow* window, const Viewport& area, vtkTextureObject* picture);
  std::string drawOver(vtkOpenGLRenderWindow* window, const Viewport& area,
    vtkTextureObject* picture, const char* shader);

  FloatTarget Target;
  AdaptivePicture Adaptive;
  UploadedImage Shown; // a picture that was made elsewhere
  TileSchedule Tiles;
  int Draws = 0;
  ShaderDraw Draw;
};

} // namespace tetmarch

#endif
