// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What stands in a window after volumes have been blended over what was there
 */
#ifndef tetmarch_testing_BlendedFrame_h
#define tetmarch_testing_BlendedFrame_h

#include "Scene.h"

#include <gtest/gtest.h>
#include <iostream>
#include <string>

namespace tetmarch::testing
{
/// One blend in a framebuffer of bytes: what comes in, what it is multiplied with and the result
/// may each be rounded by half a byte (llvmpipe does so).
constexpr double OneBlend = 1.5 / 255.0;

/// Of premultiplied colours.
inline Image over(const Image& front, const Image& back)
{
  Image result(front.Width, front.Height);
  for (std::size_t i = 0; i < result.Rgba.size(); ++i)
  {
    result.Rgba[i] = front.Rgba[i] + (1.0f - front.Rgba[i | 3]) * back.Rgba[i];
  }
  return result;
}

/// The rest of the scene.
inline Image frameWithoutVolumes(Scene& scene)
{
  scene.Volume->VisibilityOff();
  scene.Window->Render();
  const Image frame = scene.frame();
  scene.Volume->VisibilityOn();
  return frame;
}

/// Of colours without alpha, at most so far apart. Prints the figures.
inline void expectSame(const Image& a, const Image& b, double bound, const std::string& what = {})
{
  const Difference difference = compare(a, b, {}, bound, Channels::Rgb);
  EXPECT_LE(difference.Max, bound) << what << ' ' << difference.text();
  std::cout << "[ MEASURED ] " << what << ' ' << difference.text() << '\n';
}
} // namespace tetmarch::testing

#endif
