// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The depths of the opaque geometry that is in the framebuffer.
#ifndef TetMarchGLOpaqueDepth_h
#define TetMarchGLOpaqueDepth_h

#include "GL/UploadedImage.h"
#include "GL/Viewport.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkWindow;

namespace tetmarch
{

/** Whether anything in the renderer, or in a layer below whose depths it keeps, may be opaque. If
 * not, no ray needs depths. */
bool mayHaveOpaqueGeometry(vtkRenderer* renderer);

class OpaqueDepth
{
public:
  /** Copy the depths of the viewport from the framebuffer that is drawn into, whatever its format
   * and number of samples. Returns an empty string, or what is wrong. */
  std::string capture(vtkOpenGLRenderWindow* window, const Viewport& viewport);
  /** Have the texture show these depths instead of those that were captured: as many. */
  std::string replace(vtkOpenGLRenderWindow* window, const std::vector<float>& depths);
  /** Window depths in 0..1 in red; nearest filter. */
  vtkTextureObject* texture() const
  {
    return this->Replaced.texture() ? this->Replaced.texture() : this->Depth.Get();
  }
  /** One a pixel, rows from the bottom. */
  std::vector<float> read(vtkOpenGLRenderWindow* window) const;
  void release(vtkWindow* window);
  std::size_t bytes() const { return this->Bytes + this->Replaced.bytes(); }

private:
  /** The storage format of a depth attachment: a blit needs the same format on both sides. */
  struct Format
  {
    int DepthBits = 0;
    int StencilBits = 0;
    bool Float = false;
    bool operator!=(const Format& other) const
    {
      return this->DepthBits != other.DepthBits || this->StencilBits != other.StencilBits ||
             this->Float != other.Float;
    }
  };
  static Format formatOf(unsigned int framebuffer);
  void allocateDepth(const Viewport& viewport);
  void allocate(vtkOpenGLRenderWindow* window, const Viewport& viewport, const Format& format);

  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  vtkSmartPointer<vtkTextureObject> Color;
  vtkSmartPointer<vtkTextureObject> Depth;
  UploadedImage Replaced;
  Format Present;
  int Width = 0;
  int Height = 0;
  std::size_t Bytes = 0;
};

} // namespace tetmarch

#endif
