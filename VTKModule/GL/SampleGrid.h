// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A grid of samples of a part of a picture, as in Shaders/passes/sample_grid.glsl.
#ifndef TetMarchGLSampleGrid_h
#define TetMarchGLSampleGrid_h

#include "GL/Viewport.h"

#include "vtkShaderProgram.h"

#include <array>

namespace tetmarch
{

struct SampleGrid
{
  Viewport Part{ 0, 0, 1, 1 }; // of the picture
  int Spacing = 1;

  int width() const { return samplesOf(this->Part.Width); }
  int height() const { return samplesOf(this->Part.Height); }
  Viewport area() const { return { 0, 0, this->width(), this->height() }; }
  SampleGrid finer() const { return { this->Part, this->Spacing / 2 }; }

  void bind(vtkShaderProgram* program) const
  {
    const std::array<int, 2> sample{ { this->width() - 1, this->height() - 1 } };
    const std::array<int, 2> first{ { this->Part.X, this->Part.Y } };
    const std::array<int, 2> pixel{ { this->Part.Width - 1, this->Part.Height - 1 } };
    program->SetUniform2i("lastSample", sample.data());
    program->SetUniform2i("firstPixel", first.data());
    program->SetUniform2i("lastPixel", pixel.data());
    program->SetUniformi("spacing", this->Spacing);
  }

private:
  // The last pixel is a sample, too.
  int samplesOf(int pixels) const { return (pixels - 1 + this->Spacing - 1) / this->Spacing + 1; }
};

} // namespace tetmarch

#endif
