// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/UploadedImage.h"

#include "GL/ErrorQueue.h"
#include "GL/StateScope.h"

namespace tetmarch
{

bool UploadedImage::upload(vtkOpenGLRenderWindow* window, int width, int height, int numbers,
  const std::vector<float>& pixels)
{
  StateScope state(window);
  clearErrors();
  if (!this->Texture)
  {
    this->Texture = vtkSmartPointer<vtkTextureObject>::New();
  }
  this->Texture->SetContext(window);
  this->Texture->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  const bool made = this->Texture->Create2DFromRaw(static_cast<unsigned int>(width),
    static_cast<unsigned int>(height), numbers, VTK_FLOAT,
    const_cast<float*>(pixels.data())); // VTK's signature; it is only read
  if (!made || !hasRoom(this->Texture))
  {
    this->release(window);
    return false;
  }
  this->Bytes = pixels.size() * sizeof(float);
  return true;
}

void UploadedImage::release(vtkWindow* window)
{
  if (this->Texture)
  {
    this->Texture->ReleaseGraphicsResources(window);
    this->Texture = nullptr;
  }
  this->Bytes = 0;
}

} // namespace tetmarch
