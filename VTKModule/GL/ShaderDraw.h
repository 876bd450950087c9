// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A shader program, and draw calls without vertex buffers.
#ifndef TetMarchGLShaderDraw_h
#define TetMarchGLShaderDraw_h

#include "Variants/ShaderTexts.h"

#include "vtkNew.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <map>
#include <optional>
#include <string>
#include <utility>

class vtkOpenGLRenderWindow;
class vtkOpenGLShaderCache;
class vtkShaderProgram;
class vtkWindow;

namespace tetmarch
{

class PeelHooks;

class ShaderDraw
{
public:
  /** Compile the program, or find it in the window's cache, and use it. Hooks edit the text of both
   * shaders before. Returns nullptr on failure, and `error` says which file is wrong. What was used
   * before is found without its text: VTK's cache edits and hashes all of that each time. */
  vtkShaderProgram* use(vtkOpenGLRenderWindow* window, const std::string& vertexFile,
    const std::string& fragmentFile, const std::string& defines, std::string& error,
    const PeelHooks* hooks = nullptr);
  /** Draw so many triangles, whose vertices the vertex shader makes from their number. */
  void drawTriangles(int count);
  void release();

private:
  vtkNew<vtkOpenGLVertexArrayObject> VertexArray;
  std::optional<std::string> DriverDefines; // as long as the context lives
  ShaderTexts Texts;
  vtkWeakPointer<vtkOpenGLShaderCache> Cache; // that has the programs
  using TwoTexts = std::pair<const std::string*, const std::string*>;
  std::map<TwoTexts, vtkSmartPointer<vtkShaderProgram>> Programs; // by their texts, without hooks
};

} // namespace tetmarch

#endif
