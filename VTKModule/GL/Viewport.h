// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of the framebuffer that is drawn into, in pixels.
#ifndef TetMarchGLViewport_h
#define TetMarchGLViewport_h

#include <algorithm>
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

/** What both have; without pixels if they have none in common. */
inline Viewport overlapOf(const Viewport& a, const Viewport& b)
{
  const int x = std::max(a.X, b.X);
  const int y = std::max(a.Y, b.Y);
  return { x, y, std::max(std::min(a.X + a.Width, b.X + b.Width) - x, 0),
    std::max(std::min(a.Y + a.Height, b.Y + b.Height) - y, 0) };
}

} // namespace tetmarch

#endif
