// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Numbers of pixels from the computer's memory, as a texture.
#ifndef TetMarchGLUploadedImage_h
#define TetMarchGLUploadedImage_h

#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <vector>

class vtkOpenGLRenderWindow;
class vtkWindow;

namespace tetmarch
{

class UploadedImage
{
public:
  /** So many numbers a pixel, rows from the bottom; nearest filter. False if the GPU has no room
   * for them: then there is no texture. */
  bool upload(vtkOpenGLRenderWindow* window, int width, int height, int numbers,
    const std::vector<float>& pixels);
  /** Null if there is none. */
  vtkTextureObject* texture() const { return this->Texture; }
  void release(vtkWindow* window);
  std::size_t bytes() const { return this->Bytes; }

private:
  vtkSmartPointer<vtkTextureObject> Texture;
  std::size_t Bytes = 0;
};

} // namespace tetmarch

#endif
