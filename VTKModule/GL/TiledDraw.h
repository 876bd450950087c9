// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Draws a picture in several draw calls so that each is short.
#ifndef TetMarchGLTiledDraw_h
#define TetMarchGLTiledDraw_h

#include "Budget/TileSchedule.h"
#include "GL/DrawContext.h"
#include "GL/Viewport.h"

#include <functional>
#include <string>

namespace tetmarch
{

struct TiledArea
{
  Viewport Pixels;
  double MostSeconds; // of a tile; 0: no limit
  const PictureContent& Content;
};

/**
 * Call `draw` once for each tile of the area, as far as the scissor box lets it through. It
 * returns an empty string, or what is wrong. Between tiles the GL state is as before, and the
 * report is asked, which may stop the picture.
 */
StageResult drawInTiles(const DrawContext& context, const TiledArea& area, TileSchedule& schedule,
  const std::function<std::string(const Viewport& tile)>& draw);

/** A part of a picture, both in pixels. */
ScreenBox screenBoxOf(const Viewport& part, const Viewport& whole);

} // namespace tetmarch

#endif
