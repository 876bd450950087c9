// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Restores the GL state that a pass changes when the scope ends.
#ifndef TetMarchGLStateScope_h
#define TetMarchGLStateScope_h

#include "GL/ErrorQueue.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

namespace tetmarch
{

class StateScope
{
public:
  explicit StateScope(vtkOpenGLRenderWindow* window)
    : State(window->GetState())
  {
    this->State->Push();
  }
  ~StateScope() { this->State->Pop(); }
  StateScope(const StateScope&) = delete;
  StateScope& operator=(const StateScope&) = delete;

  vtkOpenGLState* operator->() const { return this->State; }

private:
  vtkOpenGLState* State;
};

/** Triangles replace the pixels in the scissor box: no blending, tests of depth or culling. */
class ReplaceScope : public StateScope
{
public:
  explicit ReplaceScope(vtkOpenGLRenderWindow* window)
    : StateScope(window)
  {
    for (const unsigned int capability : { GL_BLEND, GL_DEPTH_TEST, GL_CULL_FACE })
    {
      (*this)->vtkglDisable(capability);
    }
  }
};

/** The same for every pixel and channel of a target of our own, which has that size. */
class TargetScope : public ReplaceScope
{
public:
  TargetScope(vtkOpenGLRenderWindow* window, int width, int height)
    : ReplaceScope(window)
  {
    (*this)->vtkglDisable(GL_SCISSOR_TEST);
    (*this)->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    (*this)->vtkglViewport(0, 0, width, height);
  }
};

/**
 * VTK's record of the state has the array buffers that were bound when it was last read from the
 * GL, as at a vtkHardwareSelector's begin. Pop() binds them again, though they may have been
 * deleted. If so, read the record again.
 */
inline void forgetLostBuffers(vtkOpenGLRenderWindow* window)
{
  clearErrors();
  {
    const StateScope unchanged(window);
  }
  if (glGetError() != GL_NO_ERROR)
  {
    window->GetState()->Reset();
  }
}

} // namespace tetmarch

#endif
