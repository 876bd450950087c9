// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A compute shader, and its dispatches: ShaderDraw's counterpart. VTK 9.1 has none.
#ifndef TetMarchGLComputeDispatch_h
#define TetMarchGLComputeDispatch_h

#include "Variants/ShaderStage.h"
#include "Variants/ShaderTexts.h"

#include <map>
#include <memory>
#include <optional>
#include <string>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace tetmarch
{

class ComputePrograms;
class FloatTarget;
struct Viewport;

/** Of the current context. */
ComputeSupport computeSupport();

class ComputeDispatch
{
public:
  /** Compile the program, or find it among those of the window, and use it: until dispatch() its
   * uniforms can be set. Returns nullptr on failure, and `error` says which file is wrong. */
  vtkShaderProgram* use(vtkOpenGLRenderWindow* window, const std::string& file,
    const std::string& defines, std::string& error);
  /** Run an invocation for each pixel of the tile, its uniform `tilePixels`, in groups of 8 x 8.
   * What they write into the target's images can then be drawn with and read. */
  void dispatch(vtkShaderProgram* program, const FloatTarget& target, const Viewport& tile);
  void release();

private:
  std::shared_ptr<ComputePrograms> Programs;
  std::optional<std::string> DriverDefines; // as long as the context lives
  ShaderTexts Texts;
  std::map<const std::string*, vtkShaderProgram*> ByText; // of these programs
};

} // namespace tetmarch

#endif
