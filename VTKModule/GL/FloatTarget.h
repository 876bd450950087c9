// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A framebuffer of our own with colour textures of numbers and, if wanted, a depth texture.
#ifndef TetMarchGLFloatTarget_h
#define TetMarchGLFloatTarget_h

#include "GL/Viewport.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkWindow;

namespace tetmarch
{

enum class TargetFormat
{
  Float32, // RGBA32F
  Share16  // RGBA16: 0..1 in 65536 steps
};

class FloatTarget
{
public:
  /**
   * Make the framebuffer if it isn't there, give it the size, and bind it for drawing into all its
   * colours. The caller restores framebuffer bindings (StateScope). Returns an empty string, or
   * what is wrong.
   */
  std::string bind(vtkOpenGLRenderWindow* window, int width, int height, int colors,
    TargetFormat format = TargetFormat::Float32);
  /** Bind it for drawing as it is. */
  std::string bindAgain(vtkOpenGLRenderWindow* window)
  {
    return this->bind(
      window, this->Width, this->Height, static_cast<int>(this->Colors.size()), this->Format);
  }
  int width() const { return this->Width; }
  int height() const { return this->Height; }
  /** Let a compute shader write the colours, as images 0, 1 and so on. */
  void bindImages() const;
  void unbindImages() const;
  vtkTextureObject* color(int i) const { return this->Colors[i]; }
  /** The pixels of colour i, rows from the bottom. */
  std::vector<float> read(vtkOpenGLRenderWindow* window, int i) const
  {
    std::vector<float> pixels;
    this->read(window, i, { 0, 0, this->Width, this->Height }, pixels);
    return pixels;
  }
  /** Those of a part. */
  void read(
    vtkOpenGLRenderWindow* window, int i, const Viewport& part, std::vector<float>& pixels) const;
  /** Replace the pixels of colour i, of 32 bits. */
  void write(int i, const std::vector<float>& pixels) const;
  /** Copy a part of colour i to colour j of another target of the same size. */
  void copy(
    vtkOpenGLRenderWindow* window, int i, const FloatTarget& to, int j, const Viewport& part) const;
  void release(vtkWindow* window);
  std::size_t bytes() const { return this->Bytes; }

private:
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  std::vector<vtkSmartPointer<vtkTextureObject>> Colors;
  int Width = 0;
  int Height = 0;
  TargetFormat Format = TargetFormat::Float32;
  std::size_t Bytes = 0;
};

} // namespace tetmarch

#endif
