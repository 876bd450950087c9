// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/VisiblePartTextures.h"

#include "vtkOpenGLRenderWindow.h"

namespace tetmarch
{

std::string VisiblePartTextures::upload(
  vtkOpenGLRenderWindow* window, const VisiblePart& part, bool hasEyeFaces)
{
  const std::size_t room = hasEyeFaces ? MostEyeFaces : 0;
  this->release(window);
  this->NumberOfFaces = part.Faces.size();
  std::string error =
    this->Tets.upload(window, TexelFormat::R32UI, part.Tets.data(), part.Tets.size());
  if (error.empty())
  {
    error =
      this->Faces.upload(window, TexelFormat::RGBA32UI, part.Faces.data(), part.Faces.size(), room);
  }
  return error.empty() ? this->Links.upload(
                           window, TexelFormat::R32UI, part.Links.data(), part.Links.size(), room)
                       : error;
}

// At rest they are there.
void VisiblePartTextures::replaceEyeFaces(const EyeStart& start)
{
  if (start.Inside == this->EyeFaces)
  {
    return;
  }
  constexpr std::size_t ofFace = sizeof(start.Inside[0]);
  constexpr std::size_t ofLink = sizeof(start.Links[0]);
  const std::size_t count = start.Inside.size();
  this->Faces.replace(this->NumberOfFaces * ofFace, start.Inside.data(), count * ofFace);
  this->Links.replace(this->NumberOfFaces * ofLink, start.Links.data(), count * ofLink);
  this->EyeFaces = start.Inside;
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
  this->EyeFaces.clear();
}

} // namespace tetmarch
