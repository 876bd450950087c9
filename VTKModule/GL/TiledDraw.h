// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// One picture in as many draws as it takes for each to be short.
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
 * Call `draw`, which returns an empty string or what is wrong, once a tile of what the scissor box
 * lets through of the area. Between tiles progress is asked, with the GL state as it was. It may
 * stop the picture: `stopped` becomes true.
 */
std::string drawInTiles(vtkOpenGLRenderWindow* window, const Viewport& area, double mostSeconds,
  TileSchedule& schedule, const Progress& progress, bool& stopped,
  const std::function<std::string(const Viewport& tile)>& draw);

} // namespace tetmarch

#endif
