// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mapper/CaptureScope.h"

namespace tetmarch
{

CaptureScope* CaptureScope::Inner = nullptr;

CaptureScope::CaptureScope(vtkRenderWindow* window)
  : Window(window)
  , Outer(Inner)
{
  Inner = this;
}

CaptureScope::~CaptureScope() { Inner = this->Outer; }

CaptureScope* CaptureScope::of(vtkRenderWindow* window)
{
  CaptureScope* scope = Inner;
  while (scope && scope->Window != window)
  {
    scope = scope->Outer;
  }
  return scope;
}

} // namespace tetmarch
