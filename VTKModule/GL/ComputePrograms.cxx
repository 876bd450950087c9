// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/ComputePrograms.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <mutex>

namespace tetmarch
{
namespace
{

// The first lines; a GL may go on for pages.
constexpr int MostOfLog = 500;

std::string logOf(GLuint shader, GLuint program)
{
  std::string log(MostOfLog, '\0');
  GLsizei length = 0;
  glGetShaderInfoLog(shader, MostOfLog, &length, &log[0]);
  if (length == 0)
  {
    glGetProgramInfoLog(program, MostOfLog, &length, &log[0]);
  }
  log.resize(std::max(0, length));
  return log;
}

} // namespace

// One whose uniforms are set as those of VTK's programs are.
class ComputeProgram : public vtkShaderProgram
{
public:
  static ComputeProgram* New();
  vtkTypeMacro(ComputeProgram, vtkShaderProgram);
  ComputeProgram(const ComputeProgram&) = delete;
  ComputeProgram& operator=(const ComputeProgram&) = delete;

  // Returns whether it could be built.
  bool build(const std::string& text, std::string& log)
  {
    const GLuint shader = glCreateShader(GL_COMPUTE_SHADER);
    const GLuint program = glCreateProgram();
    const char* source = text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint compiled = GL_FALSE, linked = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled)
    {
      glAttachShader(program, shader);
      glLinkProgram(program);
      glGetProgramiv(program, GL_LINK_STATUS, &linked);
      glDetachShader(program, shader);
    }
    if (!linked)
    {
      log = logOf(shader, program);
    }
    glDeleteShader(shader);
    this->Handle = static_cast<int>(program);
    this->Linked = linked != GL_FALSE;
    return this->Linked;
  }

  void use() { glUseProgram(this->Handle); }

  void release()
  {
    glDeleteProgram(this->Handle);
    this->Handle = 0;
    this->Linked = false;
  }

protected:
  ComputeProgram() = default;
};

vtkStandardNewMacro(ComputeProgram);

std::shared_ptr<ComputePrograms> ComputePrograms::of(vtkOpenGLRenderWindow* window)
{
  static std::mutex mutex;
  static std::map<vtkOpenGLRenderWindow*, std::weak_ptr<ComputePrograms>> held;
  const std::lock_guard<std::mutex> lock(mutex);
  for (auto it = held.begin(); it != held.end();)
  {
    it = it->second.expired() ? held.erase(it) : std::next(it);
  }
  std::shared_ptr<ComputePrograms> programs = held[window].lock();
  if (!programs)
  {
    programs = std::make_shared<ComputePrograms>();
    held[window] = programs;
  }
  return programs;
}

ComputePrograms::ComputePrograms() = default;

ComputePrograms::~ComputePrograms()
{
  for (auto& program : this->ByText)
  {
    program.second->release();
  }
}

vtkShaderProgram* ComputePrograms::use(const std::string& text, std::string& log)
{
  auto found = this->ByText.find(text);
  if (found == this->ByText.end())
  {
    auto program = vtkSmartPointer<ComputeProgram>::New();
    if (!program->build(text, log))
    {
      program->release();
      return nullptr;
    }
    found = this->ByText.emplace(text, program).first;
  }
  found->second->use();
  return found->second;
}

} // namespace tetmarch
