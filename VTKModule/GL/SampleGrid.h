// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A grid of samples of a picture, as in Shaders/passes/sample_grid.glsl.
#ifndef TetMarchGLSampleGrid_h
#define TetMarchGLSampleGrid_h

#include "GL/Viewport.h"

#include "vtkShaderProgram.h"

#include <array>

namespace tetmarch
{

struct SampleGrid
{
  int PictureWidth = 1;
  int PictureHeight = 1;
  int Spacing = 1;

  int width() const { return samplesOf(this->PictureWidth); }
  int height() const { return samplesOf(this->PictureHeight); }
  Viewport area() const { return { 0, 0, this->width(), this->height() }; }
  SampleGrid finer() const
  {
    return { this->PictureWidth, this->PictureHeight, this->Spacing / 2 };
  }

  void bind(vtkShaderProgram* program) const
  {
    const std::array<int, 2> sample{ { this->width() - 1, this->height() - 1 } };
    const std::array<int, 2> pixel{ { this->PictureWidth - 1, this->PictureHeight - 1 } };
    program->SetUniform2i("lastSample", sample.data());
    program->SetUniform2i("lastPixel", pixel.data());
    program->SetUniformi("spacing", this->Spacing);
  }

private:
  // The last pixel is a sample, too.
  int samplesOf(int pixels) const { return (pixels - 1 + this->Spacing - 1) / this->Spacing + 1; }
};

} // namespace tetmarch

#endif
