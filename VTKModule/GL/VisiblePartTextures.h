// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedra of which something may be seen, and the faces by which rays enter them, on the
// GPU.
#ifndef TetMarchGLVisiblePartTextures_h
#define TetMarchGLVisiblePartTextures_h

#include "Entries/EyeStart.h"
#include "GL/TextureBuffer.h"

namespace tetmarch
{

class VisiblePartTextures
{
public:
  /** Returns an empty string, or what is wrong. */
  std::string upload(vtkOpenGLRenderWindow* window, const VisiblePart& part, bool hasEyeFaces);
  /** Put the faces inside of a start behind those of the part, which has eye faces. */
  void replaceEyeFaces(const EyeStart& start);
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
  std::size_t NumberOfFaces = 0;           // of the part
  std::vector<std::array<Id, 4>> EyeFaces; // that are there
};

} // namespace tetmarch

#endif
