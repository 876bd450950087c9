// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The programs of compute shaders of a window, which those who dispatch them share.
#ifndef TetMarchGLComputePrograms_h
#define TetMarchGLComputePrograms_h

#include "vtkSmartPointer.h"

#include <map>
#include <memory>
#include <string>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace tetmarch
{

class ComputeProgram;

class ComputePrograms
{
public:
  /** Those of the window; empty if nobody holds any. The last who holds them lets go of them with
   * the window's context current. */
  static std::shared_ptr<ComputePrograms> of(vtkOpenGLRenderWindow* window);

  ComputePrograms();
  ~ComputePrograms();
  ComputePrograms(const ComputePrograms&) = delete;
  ComputePrograms& operator=(const ComputePrograms&) = delete;

  /** Compile the text, unless that was done before, and use the program. Returns nullptr on
   * failure, and `log` is what the GL says of it. */
  vtkShaderProgram* use(const std::string& text, std::string& log);

private:
  std::map<std::string, vtkSmartPointer<ComputeProgram>> ByText;
};

} // namespace tetmarch

#endif
