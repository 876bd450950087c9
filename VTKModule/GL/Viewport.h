// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of the framebuffer that is drawn into, in pixels.
#ifndef TetMarchGLViewport_h
#define TetMarchGLViewport_h

#include <array>

namespace tetmarch
{

struct Viewport
{
  int X = 0;
  int Y = 0;
  int Width = 0;
  int Height = 0;

  std::array<float, 4> asFloats() const
  {
    return { { static_cast<float>(this->X), static_cast<float>(this->Y),
      static_cast<float>(this->Width), static_cast<float>(this->Height) } };
  }
};

} // namespace tetmarch

#endif
