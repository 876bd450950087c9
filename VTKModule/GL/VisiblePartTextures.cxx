// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/VisiblePartTextures.h"

#include "vtkOpenGLRenderWindow.h"

namespace tetmarch
{

std::string VisiblePartTextures::upload(vtkOpenGLRenderWindow* window, const VisiblePart& part)
{
  this->release(window);
  std::string error =
    this->Tets.upload(window, TexelFormat::R32UI, part.Tets.data(), part.Tets.size());
  if (error.empty())
  {
    error = this->Faces.upload(window, TexelFormat::RGBA32UI, part.Faces.data(), part.Faces.size());
  }
  return error.empty()
           ? this->Links.upload(window, TexelFormat::R32UI, part.Links.data(), part.Links.size())
           : error;
}

void VisiblePartTextures::bind(vtkShaderProgram* program)
{
  this->Tets.bind(program, "visibleTetBuffer");
  this->Faces.bind(program, "visibleFaceBuffer");
  this->Links.bind(program, "visibleLinkBuffer");
}

void VisiblePartTextures::unbind()
{
  this->Tets.unbind();
  this->Faces.unbind();
  this->Links.unbind();
}

void VisiblePartTextures::release(vtkWindow* window)
{
  this->Tets.release(window);
  this->Faces.release(window);
  this->Links.release(window);
}

} // namespace tetmarch
