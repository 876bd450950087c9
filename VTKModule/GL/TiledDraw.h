// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Draws a picture in several draw calls so that each is short.
#ifndef TetMarchGLTiledDraw_h
#define TetMarchGLTiledDraw_h

#include "Budget/TileSchedule.h"
#include "GL/Viewport.h"
#include "Mesh/Progress.h"

#include <functional>
#include <string>

class vtkOpenGLRenderWindow;

namespace tetmarch
{

/**
 * Call `draw` once for each tile of the area, as far as the scissor box lets it through. It
 * returns an empty string, or what is wrong. Between tiles the GL state is as before, and progress
 * is asked; if it stops the picture, `stopped` becomes true. The content is that of the area.
 */
std::string drawInTiles(vtkOpenGLRenderWindow* window, const Viewport& area, double mostSeconds,
  const PictureContent& content, TileSchedule& schedule, const Progress& progress, bool& stopped,
  const std::function<std::string(const Viewport& tile)>& draw);

/** A part of a picture, both in pixels. */
ScreenBox screenBoxOf(const Viewport& part, const Viewport& whole);

} // namespace tetmarch

#endif
