// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whatever a pass sets in the GL state, it is as before when the scope ends.
#ifndef TetMarchGLStateScope_h
#define TetMarchGLStateScope_h

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

} // namespace tetmarch

#endif
