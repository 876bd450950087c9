// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Tells when the GL context of a window is about to end, also to objects that no renderer of the
// window knows.
#ifndef TetMarchGLContextWatch_h
#define TetMarchGLContextWatch_h

#include "vtkSmartPointer.h"

#include <functional>

class vtkOpenGLRenderWindow;
class vtkWindow;

namespace tetmarch
{

class ContextWatch
{
public:
  ~ContextWatch();

  /** Call atEnd once, with the context current, when the window releases its GL resources. */
  void begin(vtkOpenGLRenderWindow* window, const std::function<void(vtkWindow*)>& atEnd);
  /** Stop watching. May be called from atEnd. */
  void end(vtkWindow* window);

private:
  class Sentinel;
  vtkSmartPointer<Sentinel> Watching;
};

} // namespace tetmarch

#endif
