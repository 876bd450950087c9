// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FloatPicture.h"

#include "Failure.h"

#include "vtkPixelBufferObject.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"
#include "vtkUnsignedCharArray.h"

#include <functional>

namespace tetmarch::bench
{
namespace
{
testing::Image download(vtkTextureObject* texture)
{
  unsigned int size[2] = { texture->GetWidth(), texture->GetHeight() };
  vtkIdType increments[2] = { 0, 0 };
  std::vector<float> pixels(std::size_t(4) * size[0] * size[1]);
  const auto buffer = vtk::TakeSmartPointer(texture->Download());
  if (texture->GetComponents() != 4 ||
      !buffer->Download2D(VTK_FLOAT, pixels.data(), size, 4, increments))
  {
    throw Failure("the picture in float can't be read back");
  }
  return testing::Image::fromFloats(
    static_cast<int>(size[0]), static_cast<int>(size[1]), pixels.data());
}

testing::Image readBytes(vtkRenderWindow* window)
{
  const int* size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  return testing::Image::fromBytes(size[0], size[1], pixels->GetPointer(0));
}

FloatPictures draw(
  vtkRenderWindow* window, vtkRenderer* renderer, const std::function<testing::Image()>& read)
{
  const auto drawOn = [&](double gray)
  {
    renderer->SetBackground(gray, gray, gray);
    window->Render();
    return read();
  };
  FloatPictures pictures;
  pictures.OnWhite = drawOn(1.0);
  pictures.OnBlack = drawOn(0.0);
  return pictures;
}
} // namespace

FloatFramebuffer::FloatFramebuffer(vtkRenderWindow* window, vtkRenderer* renderer)
  : Window(window)
  , Renderer(renderer)
{
  vtkNew<vtkRenderStepsPass> steps;
  this->Pass->SetDelegatePass(steps);
  this->Pass->SetColorFormat(vtkTextureObject::Float32);
  // As VTK's GPU mapper wants it: it copies the depth into a texture of that format, and keeps what
  // was there before if the GL can't convert.
  this->Pass->SetDepthFormat(vtkTextureObject::Fixed32);
  renderer->SetPass(this->Pass);
}

FloatFramebuffer::~FloatFramebuffer()
{
  this->Renderer->SetPass(nullptr);
  this->Pass->ReleaseGraphicsResources(this->Window);
}

testing::Image FloatFramebuffer::read() const { return download(this->Pass->GetColorTexture()); }

FloatPictures drawInFloat(vtkRenderWindow* window, vtkRenderer* renderer)
{
  const FloatFramebuffer framebuffer(window, renderer);
  return draw(window, renderer, [&] { return framebuffer.read(); });
}

FloatPictures drawInBytes(vtkRenderWindow* window, vtkRenderer* renderer)
{
  return draw(window, renderer, [&] { return readBytes(window); });
}
} // namespace tetmarch::bench
