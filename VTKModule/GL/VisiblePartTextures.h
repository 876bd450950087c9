// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedra of which something may be seen, and the faces by which rays enter them, on the
// GPU.
#ifndef TetMarchGLVisiblePartTextures_h
#define TetMarchGLVisiblePartTextures_h

#include "Entries/VisiblePart.h"
#include "GL/TextureBuffer.h"

namespace tetmarch
{

class VisiblePartTextures
{
public:
  /** Returns an empty string, or what is wrong. */
  std::string upload(vtkOpenGLRenderWindow* window, const VisiblePart& part);
  void bind(vtkShaderProgram* program);
  void unbind();
  void release(vtkWindow* window);
  std::size_t bytes() const
  {
    return this->Tets.bytes() + this->Faces.bytes() + this->Links.bytes();
  }

private:
  TextureBuffer Tets;
  TextureBuffer Faces;
  TextureBuffer Links;
};

} // namespace tetmarch

#endif
