// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/CellBuffer.h"

#include "GL/Driver.h"

#include "vtkOpenGLRenderWindow.h"

#include <algorithm>

namespace tetmarch
{

std::string CellBuffer::upload(
  vtkOpenGLRenderWindow* window, TexelFormat format, std::size_t count, const Texels& texels)
{
  this->release(window);
  const std::size_t first = std::min(count, mostTexels());
  std::string error = this->First.upload(window, format, first, texels);
  if (error.empty() && first < count)
  {
    error = this->Second.upload(window, format, count - first,
      [&](std::size_t begin, std::size_t end) { return texels(first + begin, first + end); });
  }
  if (!error.empty())
  {
    this->release(window);
    return error;
  }
  this->FirstTexels = first;
  return {};
}

void CellBuffer::bind(vtkShaderProgram* program, const char* first, const char* second)
{
  this->First.bind(program, first);
  if (this->isSplit())
  {
    this->Second.bind(program, second);
  }
}

void CellBuffer::unbind()
{
  this->First.unbind();
  this->Second.unbind();
}

void CellBuffer::release(vtkWindow* window)
{
  this->First.release(window);
  this->Second.release(window);
  this->FirstTexels = 0;
}

} // namespace tetmarch
