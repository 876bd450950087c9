// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/ShaderDraw.h"

#include "GL/ShaderSource.h"

#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

namespace tetmarch
{

vtkShaderProgram* ShaderDraw::use(vtkOpenGLRenderWindow* window, const std::string& vertexFile,
  const std::string& fragmentFile, const std::string& defines, std::string& error)
{
  const std::string vertex = shaderSource(vertexFile, defines);
  const std::string fragment = shaderSource(fragmentFile, defines);
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(vertex.c_str(), fragment.c_str(), "");
  if (!program)
  {
    error = "The shader " + fragmentFile +
            " could not be built; the GL's message is above. In it, sources " +
            "are numbered: " + sourceLegend() + ".";
  }
  return program;
}

void ShaderDraw::drawTriangles(int count)
{
  this->VertexArray->Bind();
  glDrawArrays(GL_TRIANGLES, 0, 3 * count);
  this->VertexArray->Release();
}

void ShaderDraw::release() { this->VertexArray->ReleaseGraphicsResources(); }

} // namespace tetmarch
