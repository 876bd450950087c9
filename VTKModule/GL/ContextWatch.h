// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Tells when a window's GL context is about to go, also those of whom no renderer of the window
// knows.
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
  /** No longer. May be called from atEnd. */
  void end(vtkWindow* window);

private:
  class Sentinel;
  vtkSmartPointer<Sentinel> Watching;
};

} // namespace tetmarch

#endif
