// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/OpaqueDepth.h"

#include "GL/ErrorQueue.h"
#include "GL/StateScope.h"

#include "vtkCollectionIterator.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkVolume.h"

namespace tetmarch
{
namespace
{

bool hasOpaqueProp(vtkRenderer* renderer)
{
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    // Volumes don't say that they have none.
    if (prop->GetVisibility() && !vtkVolume::SafeDownCast(prop) && prop->HasOpaqueGeometry())
    {
      return true;
    }
  }
  return false;
}

int attachmentParameter(unsigned int framebuffer, unsigned int attachment, unsigned int name)
{
  // Of the window's own framebuffer the attachments are called otherwise.
  if (framebuffer == 0)
  {
    attachment = attachment == GL_DEPTH_ATTACHMENT ? GL_DEPTH : GL_STENCIL;
  }
  int type = GL_NONE;
  glGetFramebufferAttachmentParameteriv(
    GL_DRAW_FRAMEBUFFER, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
  int value = 0;
  if (type != GL_NONE)
  {
    glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, name, &value);
  }
  return value;
}

} // namespace

bool mayHaveOpaqueGeometry(vtkRenderer* renderer)
{
  if (hasOpaqueProp(renderer))
  {
    return true;
  }
  if (!renderer->GetPreserveDepthBuffer() && renderer->GetErase())
  {
    return false;
  }
  vtkRendererCollection* renderers = renderer->GetRenderWindow()->GetRenderers();
  vtkCollectionSimpleIterator it;
  renderers->InitTraversal(it);
  while (vtkRenderer* other = renderers->GetNextRenderer(it))
  {
    if (other != renderer && other->GetDraw() && hasOpaqueProp(other))
    {
      return true;
    }
  }
  return false;
}

OpaqueDepth::Format OpaqueDepth::formatOf(unsigned int framebuffer)
{
  Format format;
  format.DepthBits =
    attachmentParameter(framebuffer, GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
  format.StencilBits =
    attachmentParameter(framebuffer, GL_STENCIL_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE);
  format.Float = attachmentParameter(framebuffer, GL_DEPTH_ATTACHMENT,
                   GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT;
  return format;
}

void OpaqueDepth::allocateDepth(const Viewport& viewport)
{
  const Format& format = this->Present;
  if (format.StencilBits == 0)
  {
    const int kind = format.Float ? vtkTextureObject::Float32
                                  : (format.DepthBits == 32    ? vtkTextureObject::Fixed32
                                      : format.DepthBits == 16 ? vtkTextureObject::Fixed16
                                                               : vtkTextureObject::Fixed24);
    this->Depth->AllocateDepth(viewport.Width, viewport.Height, kind);
    return;
  }
  this->Depth->AllocateDepthStencil(viewport.Width, viewport.Height); // of 24 bits
  if (format.Float)
  {
    this->Depth->Activate();
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH32F_STENCIL8, viewport.Width, viewport.Height, 0,
      GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV, nullptr);
    this->Depth->Deactivate();
  }
}

void OpaqueDepth::allocate(
  vtkOpenGLRenderWindow* window, const Viewport& viewport, const Format& format)
{
  this->release(window);
  this->Depth = vtkSmartPointer<vtkTextureObject>::New();
  this->Depth->SetContext(window);
  this->Depth->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Depth->SetMagnificationFilter(vtkTextureObject::Nearest);
  this->Present = format;
  this->allocateDepth(viewport);
  this->Color = vtkSmartPointer<vtkTextureObject>::New();
  this->Color->SetContext(window);
  this->Color->Allocate2D(viewport.Width, viewport.Height, 4, VTK_UNSIGNED_CHAR);
  this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
  this->Framebuffer->SetContext(window);
  this->Framebuffer->Bind(GL_DRAW_FRAMEBUFFER);
  this->Framebuffer->AddDepthAttachment(this->Depth);
  this->Framebuffer->AddColorAttachment(0, this->Color);
  this->Width = viewport.Width;
  this->Height = viewport.Height;
  this->Bytes = static_cast<std::size_t>(viewport.Width) * viewport.Height * 8;
}

std::string OpaqueDepth::replace(vtkOpenGLRenderWindow* window, const std::vector<float>& depths)
{
  if (!this->Replaced.upload(window, this->Width, this->Height, 1, depths))
  {
    this->release(window);
    return "The GPU has no room for the depths of opaque geometry of all processes. Close what "
           "else uses it, or make the window smaller.";
  }
  return {};
}

std::string OpaqueDepth::capture(vtkOpenGLRenderWindow* window, const Viewport& viewport)
{
  this->Replaced.release(window);
  StateScope state(window);
  int source = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &source);
  const Format format = formatOf(static_cast<unsigned int>(source));
  if (format.DepthBits == 0)
  {
    return "The framebuffer has no depths for opaque geometry.";
  }
  if (!this->Framebuffer || viewport.Width != this->Width || viewport.Height != this->Height ||
      format != this->Present)
  {
    clearErrors();
    this->allocate(window, viewport, format);
    if (!hasRoom(this->Depth) || !hasRoom(this->Color))
    {
      this->release(window);
      return "The GPU has no room for the depths of opaque geometry, " +
             std::to_string(viewport.Width) + " x " + std::to_string(viewport.Height) +
             " pixels. Close what else uses it, or make the window smaller.";
    }
  }
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<unsigned int>(source));
  this->Framebuffer->Bind(GL_DRAW_FRAMEBUFFER);
  if (!this->Framebuffer->CheckFrameBufferStatus(GL_DRAW_FRAMEBUFFER))
  {
    this->release(window);
    return "The depths of opaque geometry can't be copied: the framebuffer for them is incomplete.";
  }
  state->vtkglDisable(GL_SCISSOR_TEST);
  clearErrors();
  glBlitFramebuffer(viewport.X, viewport.Y, viewport.X + viewport.Width,
    viewport.Y + viewport.Height, 0, 0, viewport.Width, viewport.Height, GL_DEPTH_BUFFER_BIT,
    GL_NEAREST);
  if (glGetError() != GL_NO_ERROR)
  {
    this->release(window);
    return "The depths of opaque geometry (" + std::to_string(format.DepthBits) +
           " bits, stencil " + std::to_string(format.StencilBits) + " bits) could not be copied.";
  }
  return {};
}

std::vector<float> OpaqueDepth::read(vtkOpenGLRenderWindow* window) const
{
  std::vector<float> depths(static_cast<std::size_t>(this->Width) * this->Height);
  StateScope state(window);
  this->Framebuffer->Bind(GL_READ_FRAMEBUFFER);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, this->Width, this->Height, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
  return depths;
}

void OpaqueDepth::release(vtkWindow* window)
{
  if (this->Framebuffer)
  {
    this->Framebuffer->ReleaseGraphicsResources(window);
    this->Color->ReleaseGraphicsResources(window);
    this->Depth->ReleaseGraphicsResources(window);
  }
  this->Replaced.release(window);
  this->Framebuffer = nullptr;
  this->Color = nullptr;
  this->Depth = nullptr;
  this->Bytes = 0;
}

} // namespace tetmarch
