// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Draws a tile of a target as triangles, for Shaders/passes/tile.vert.glsl.
#ifndef TetMarchGLTileCorners_h
#define TetMarchGLTileCorners_h

#include "GL/ShaderDraw.h"
#include "GL/Viewport.h"

#include "vtkShaderProgram.h"

#include <array>

namespace tetmarch
{

/** As two triangles, with the program that is in use. */
inline void drawRectangle(
  vtkShaderProgram* program, ShaderDraw& draw, const Viewport& target, const Viewport& tile)
{
  // In normalised device coordinates of the target.
  const auto ndc = [](int pixel, int size) { return static_cast<float>(2.0 * pixel / size - 1.0); };
  const int x = tile.X - target.X;
  const int y = tile.Y - target.Y;
  const std::array<float, 4> corners{ { ndc(x, target.Width), ndc(y, target.Height),
    ndc(x + tile.Width, target.Width), ndc(y + tile.Height, target.Height) } };
  program->SetUniform4f("tile", corners.data());
  draw.drawTriangles(2);
}

/** The same, but the whole target as one triangle. */
inline void drawCorners(
  vtkShaderProgram* program, ShaderDraw& draw, const Viewport& target, const Viewport& tile)
{
  // Not by a scissor box: llvmpipe draws its edges wrong where pixels have several samples.
  if (tile.Width < target.Width || tile.Height < target.Height)
  {
    drawRectangle(program, draw, target, tile);
    return;
  }
  const std::array<float, 4> covering{ { -1, -1, 3, 3 } };
  program->SetUniform4f("tile", covering.data());
  draw.drawTriangles(1);
}

} // namespace tetmarch

#endif
