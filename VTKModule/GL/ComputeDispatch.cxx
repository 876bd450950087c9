// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/ComputeDispatch.h"

#include "GL/ComputePrograms.h"
#include "GL/Driver.h"
#include "GL/FloatTarget.h"
#include "GL/Viewport.h"
#include "Variants/ShaderSource.h"

#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <array>

namespace tetmarch
{
namespace
{

constexpr int GroupSide = 8; // pixels

// VTK's loader of the GL looks each function up; a driver may lack one that its version has.
bool hasFunctions() { return glDispatchCompute && glBindImageTexture && glMemoryBarrier; }

// In the place of what VTK's cache puts before the other shaders.
std::string withVersion(std::string text)
{
  const std::string tag = "//VTK::System::Dec";
  return text.replace(text.find(tag), tag.size(), "#version 430 core");
}

} // namespace

ComputeSupport computeSupport()
{
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const bool exists = hasVersion(4, 3) && hasFunctions();
  return { exists, exists && renderer && hasFewFragmentUnits(renderer) };
}

vtkShaderProgram* ComputeDispatch::use(vtkOpenGLRenderWindow* window, const std::string& file,
  const std::string& defines, std::string& error)
{
  if (!this->DriverDefines)
  {
    this->DriverDefines = driverDefines();
  }
  if (!this->Programs)
  {
    this->Programs = ComputePrograms::of(window);
  }
  const std::string& text = this->Texts.of(file, defines + *this->DriverDefines);
  // The cache takes its last program for the one that is in use.
  window->GetShaderCache()->ReleaseCurrentShader();
  const auto known = this->ByText.find(&text);
  if (known != this->ByText.end())
  {
    glUseProgram(known->second->GetHandle());
    return known->second;
  }
  std::string log;
  vtkShaderProgram* program = this->Programs->use(withVersion(text), log);
  if (program)
  {
    this->ByText[&text] = program;
  }
  else
  {
    error = "The compute shader " + file + " could not be built" +
            (log.empty() ? ", and the GL does not say why." : ":\n" + withFileNames(log));
  }
  return program;
}

void ComputeDispatch::dispatch(
  vtkShaderProgram* program, const FloatTarget& target, const Viewport& tile)
{
  const std::array<float, 4> pixels = tile.asFloats();
  program->SetUniform4f("tilePixels", pixels.data());
  const auto groups = [](int side)
  { return static_cast<GLuint>(std::max(1, (side + GroupSide - 1) / GroupSide)); };
  target.bindImages();
  glDispatchCompute(groups(tile.Width), groups(tile.Height), 1);
  target.unbindImages();
  glMemoryBarrier(
    GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT | GL_PIXEL_BUFFER_BARRIER_BIT);
  glUseProgram(0);
}

void ComputeDispatch::release()
{
  this->Programs.reset();
  this->ByText.clear();
  this->Texts.clear();
  this->DriverDefines.reset();
}

} // namespace tetmarch
