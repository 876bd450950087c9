// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/ShaderDraw.h"

#include "GL/Driver.h"
#include "GL/PeelHooks.h"
#include "Variants/ShaderSource.h"

#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"

#include <map>
#include <vector>

namespace tetmarch
{
namespace
{

using Shaders = std::map<vtkShader::Type, vtkShader*>;

// VTK lists shaders of all types that it knows, most of them empty.
class TypedShaders
{
public:
  TypedShaders(std::string vertexText, std::string fragmentText, const PeelHooks* hooks)
  {
    for (int type = vtkShader::Vertex; type < vtkShader::Unknown; ++type)
    {
      this->Owned.push_back(vtkSmartPointer<vtkShader>::New());
      this->Owned.back()->SetType(static_cast<vtkShader::Type>(type));
      this->All[static_cast<vtkShader::Type>(type)] = this->Owned.back();
    }
    if (hooks)
    {
      hooks->edit(vertexText, fragmentText);
    }
    this->All[vtkShader::Vertex]->SetSource(vertexText);
    this->All[vtkShader::Fragment]->SetSource(fragmentText);
  }

  const Shaders& all() const { return this->All; }

private:
  std::vector<vtkSmartPointer<vtkShader>> Owned;
  Shaders All;
};

// What a cache keeps of a program that it could not build.
class CacheAccess : public vtkOpenGLShaderCache
{
public:
  static vtkShaderProgram* find(vtkOpenGLShaderCache* cache, const Shaders& shaders)
  {
    vtkShaderProgram* (vtkOpenGLShaderCache::*get)(Shaders) = &CacheAccess::GetShaderProgram;
    return (cache->*get)(shaders);
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
  const std::string& fragmentFile, const std::string& defines, std::string& error,
  const PeelHooks* hooks)
{
  if (!this->DriverDefines)
  {
    this->DriverDefines = driverDefines();
  }
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  if (this->Cache != cache)
  {
    this->Programs.clear();
    this->Cache = cache;
  }
  const std::string allDefines = defines + *this->DriverDefines;
  const std::string& vertexText = this->Texts.of(vertexFile, allDefines);
  const std::string& fragmentText = this->Texts.of(fragmentFile, allDefines);
  const auto known = this->Programs.find({ &vertexText, &fragmentText });
  if (!hooks && known != this->Programs.end())
  {
    if (vtkShaderProgram* program = cache->ReadyShaderProgram(known->second))
    {
      return program;
    }
  }
  TypedShaders shaders(vertexText, fragmentText, hooks);
  vtkShaderProgram* program = cache->ReadyShaderProgram(shaders.all());
  if (!program)
  {
    vtkShaderProgram* failed = CacheAccess::find(cache, shaders.all());
    const std::string message = messageOf(failed);
    error = "The shader of " + vertexFile + " and " + fragmentFile + " could not be built" +
            (message.empty() ? ", and the GL does not say why."
                             : ":\n" + beginning(withFileNames(message)));
    // Else the half that did compile is taken for an error when it is tried again.
    failed->GetVertexShader()->Cleanup();
    failed->GetFragmentShader()->Cleanup();
  }
  else if (!hooks)
  {
    this->Programs[{ &vertexText, &fragmentText }] = program;
  }
  return program;
}

void ShaderDraw::drawTriangles(int count)
{
  this->VertexArray->Bind();
  glDrawArrays(GL_TRIANGLES, 0, 3 * count);
  this->VertexArray->Release();
}

void ShaderDraw::release()
{
  this->VertexArray->ReleaseGraphicsResources();
  this->DriverDefines.reset();
  this->Programs.clear();
  this->Texts.clear();
}

} // namespace tetmarch
