// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/FloatTarget.h"

#include "GL/ErrorQueue.h"

#include "vtkNew.h"
#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <algorithm>
#include <numeric>

namespace tetmarch
{
namespace
{

std::string describe(int width, int height, int colors, bool wide)
{
  return std::to_string(colors) + (wide ? " float" : " 16-bit") + " texture(s) of " +
         std::to_string(width) + " x " + std::to_string(height) + " pixels";
}

} // namespace

std::string FloatTarget::bind(
  vtkOpenGLRenderWindow* window, int width, int height, int colors, TargetFormat format)
{
  const bool wide = format == TargetFormat::Float32;
  if (width != this->Width || height != this->Height || format != this->Format ||
      !this->Framebuffer)
  {
    this->release(window);
    clearErrors();
    this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
    this->Framebuffer->SetContext(window);
    this->Framebuffer->Bind();
    for (int i = 0; i < colors; ++i)
    {
      vtkNew<vtkTextureObject> color;
      color->SetContext(window);
      color->SetMinificationFilter(vtkTextureObject::Nearest);
      color->SetMagnificationFilter(vtkTextureObject::Nearest);
      color->Allocate2D(width, height, 4, wide ? VTK_FLOAT : VTK_UNSIGNED_SHORT);
      this->Framebuffer->AddColorAttachment(i, color);
      this->Colors.emplace_back(color);
    }
    this->Width = width;
    this->Height = height;
    this->Format = format;
    this->Bytes = static_cast<std::size_t>(width) * height * (wide ? 16 : 8) * colors;
    if (!std::all_of(this->Colors.begin(), this->Colors.end(), hasRoom))
    {
      this->release(window);
      return "The GPU has no room for " + describe(width, height, colors, wide) +
             ". Close what else uses it, or make the window smaller.";
    }
  }
  this->Framebuffer->Bind();
  this->Framebuffer->ActivateDrawBuffers(colors);
  // VTK's record of the state takes the buffers of the framebuffer that was bound before for those
  // of this one, and sets none.
  std::vector<GLenum> buffers(colors);
  std::iota(buffers.begin(), buffers.end(), GLenum(GL_COLOR_ATTACHMENT0));
  glDrawBuffers(colors, buffers.data());
  if (!this->Framebuffer->CheckFrameBufferStatus(GL_FRAMEBUFFER))
  {
    this->release(window);
    return "The GL can't draw into " + describe(width, height, colors, wide) +
           ": its framebuffer is incomplete.";
  }
  return {};
}

void FloatTarget::bindImages() const
{
  const GLenum format = this->Format == TargetFormat::Float32 ? GL_RGBA32F : GL_RGBA16;
  for (std::size_t i = 0; i < this->Colors.size(); ++i)
  {
    glBindImageTexture(
      static_cast<GLuint>(i), this->Colors[i]->GetHandle(), 0, GL_FALSE, 0, GL_WRITE_ONLY, format);
  }
}

void FloatTarget::unbindImages() const
{
  for (std::size_t i = 0; i < this->Colors.size(); ++i)
  {
    glBindImageTexture(static_cast<GLuint>(i), 0, 0, GL_FALSE, 0, GL_READ_ONLY, GL_R8);
  }
}

void FloatTarget::read(
  vtkOpenGLRenderWindow* window, int i, const Viewport& part, std::vector<float>& pixels) const
{
  pixels.resize(4 * static_cast<std::size_t>(part.Width) * part.Height);
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  this->Framebuffer->Bind();
  this->Framebuffer->ActivateReadBuffer(i);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(part.X, part.Y, part.Width, part.Height, GL_RGBA, GL_FLOAT, pixels.data());
  state->PopFramebufferBindings();
}

void FloatTarget::write(int i, const std::vector<float>& pixels) const
{
  this->Colors[i]->Activate();
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexSubImage2D(
    GL_TEXTURE_2D, 0, 0, 0, this->Width, this->Height, GL_RGBA, GL_FLOAT, pixels.data());
  this->Colors[i]->Deactivate();
}

void FloatTarget::copy(
  vtkOpenGLRenderWindow* window, int i, const FloatTarget& to, int j, const Viewport& part) const
{
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  this->Framebuffer->Bind();
  this->Framebuffer->ActivateReadBuffer(i);
  to.Colors[j]->Activate();
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, part.X, part.Y, part.X, part.Y, part.Width, part.Height);
  to.Colors[j]->Deactivate();
  state->PopFramebufferBindings();
}

void FloatTarget::release(vtkWindow* window)
{
  if (this->Framebuffer)
  {
    this->Framebuffer->ReleaseGraphicsResources(window);
    this->Framebuffer = nullptr;
  }
  for (auto& color : this->Colors)
  {
    color->ReleaseGraphicsResources(window);
  }
  this->Colors.clear();
  this->Width = this->Height = 0;
  this->Bytes = 0;
}

} // namespace tetmarch
