// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/ShaderDraw.h"

#include "GL/ShaderSource.h"

#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"

namespace tetmarch
{

namespace
{

// What a cache keeps of a program that it could not build.
class CacheAccess : public vtkOpenGLShaderCache
{
public:
  static vtkShaderProgram* find(
    vtkOpenGLShaderCache* cache, std::string vertex, std::string fragment)
  {
    std::string geometry;
    const auto replace = &CacheAccess::ReplaceShaderValues;
    (cache->*replace)(vertex, fragment, geometry);
    vtkShaderProgram* (vtkOpenGLShaderCache::*get)(const char*, const char*, const char*) =
      &CacheAccess::GetShaderProgram;
    return (cache->*get)(vertex.c_str(), fragment.c_str(), geometry.c_str());
  }
};

// The first lines of the GL's message; it may go on for pages.
std::string beginning(const std::string& log)
{
  constexpr std::size_t most = 500;
  return log.size() <= most ? log : log.substr(0, log.find('\n', most)) + "\n...";
}

std::string messageOf(vtkShaderProgram* program)
{
  for (vtkShader* shader : { program->GetVertexShader(), program->GetFragmentShader() })
  {
    if (shader->GetHandle() == 0)
    {
      return shader->GetError();
    }
  }
  return program->GetError();
}

} // namespace

vtkShaderProgram* ShaderDraw::use(vtkOpenGLRenderWindow* window, const std::string& vertexFile,
  const std::string& fragmentFile, const std::string& defines, std::string& error)
{
  const std::string vertex = shaderSource(vertexFile, defines);
  const std::string fragment = shaderSource(fragmentFile, defines);
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  vtkShaderProgram* program = cache->ReadyShaderProgram(vertex.c_str(), fragment.c_str(), "");
  if (!program)
  {
    vtkShaderProgram* failed = CacheAccess::find(cache, vertex, fragment);
    const std::string message = messageOf(failed);
    error = "The shader of " + vertexFile + " and " + fragmentFile + " could not be built" +
            (message.empty() ? ", and the GL does not say why."
                             : ":\n" + beginning(withFileNames(message)));
    // Else the half that did compile is taken for an error when it is tried again.
    failed->GetVertexShader()->Cleanup();
    failed->GetFragmentShader()->Cleanup();
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
