// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/TiledDraw.h"

#include "GL/StateScope.h"

#include "vtkOpenGLRenderUtilities.h"

#include <chrono>

namespace tetmarch
{
namespace
{

Viewport withinScissor(vtkOpenGLState* state, const Viewport& area)
{
  if (!state->GetEnumState(GL_SCISSOR_TEST))
  {
    return area;
  }
  std::array<int, 4> box{};
  state->vtkglGetIntegerv(GL_SCISSOR_BOX, box.data());
  return overlapOf(area, { box[0], box[1], box[2], box[3] });
}

// Observers may change the GL state and draw in other windows.
bool askToGoOn(const DrawContext& context, double share)
{
  StateScope state(context.Window);
  const bool goOn = !context.Report || context.Report(share);
  context.Window->MakeCurrent();
  return goOn;
}

} // namespace

ScreenBox screenBoxOf(const Viewport& part, const Viewport& whole)
{
  const auto onScreen = [](int pixel, int begin, int size)
  { return 2.0 * (pixel - begin) / size - 1; };
  return { { { onScreen(part.X, whole.X, whole.Width), onScreen(part.Y, whole.Y, whole.Height) } },
    { { onScreen(part.X + part.Width, whole.X, whole.Width),
      onScreen(part.Y + part.Height, whole.Y, whole.Height) } } };
}

StageResult drawInTiles(const DrawContext& context, const TiledArea& whole, TileSchedule& schedule,
  const std::function<std::string(const Viewport& tile)>& draw)
{
  using Clock = std::chrono::steady_clock;
  const Viewport& area = whole.Pixels;
  const bool measured = whole.MostSeconds > 0;
  const Viewport visible = withinScissor(context.Window->GetState(), area);
  PictureContent drawn = whole.Content;
  if (visible.Width != area.Width || visible.Height != area.Height)
  {
    drawn.Drawn = screenBoxOf(visible, area);
  }
  schedule.begin(visible.Width, visible.Height, whole.MostSeconds, drawn);
  if (measured)
  {
    glFinish(); // so that earlier draws are not measured
  }
  Tile tile;
  while (schedule.next(tile))
  {
    const auto begin = Clock::now();
    const std::string error =
      draw({ visible.X + tile.X, visible.Y + tile.Y, tile.Width, tile.Height });
    if (!error.empty())
    {
      return { error };
    }
    if (measured)
    {
      glFinish();
      schedule.drawn(std::chrono::duration<double>(Clock::now() - begin).count());
    }
    if (!schedule.finished() && !askToGoOn(context, schedule.share()))
    {
      return stoppedUnless(false);
    }
  }
  return {};
}

} // namespace tetmarch
