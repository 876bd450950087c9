// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/VisitPass.h"

#include "GL/StateScope.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

constexpr int Colors = 4;         // as passes/visit.frag.glsl writes them
constexpr int MostVisits = 65535; // of a pixel, as they are sent

bool showsSomething(const Visit& visit, BlendGroup blend)
{
  switch (blend)
  {
    case BlendGroup::Extreme:
      return visit.Gathered[0] != emptyPixel(MergeRule::Greatest).Gathered[0];
    case BlendGroup::Sum:
      return visit.Gathered[1] > 0; // the length that counts
    default:
      return visit.Gathered[3] < 1; // transmittance
  }
}

// The area grows so that it has the pixel.
void addPixel(int x, int y, Viewport& area)
{
  if (area.Width == 0)
  {
    area = { x, y, 1, 1 };
    return;
  }
  const int right = std::max(area.X + area.Width, x + 1);
  const int top = std::max(area.Y + area.Height, y + 1);
  area.X = std::min(area.X, x);
  area.Y = std::min(area.Y, y);
  area.Width = right - area.X;
  area.Height = top - area.Y;
}

} // namespace

std::string VisitPass::collect(vtkOpenGLRenderWindow* window, MarchPass& march,
  const MarchInputs& inputs, const Band& band, float atOnce, std::uint64_t mostBytes,
  const Progress& progress, bool& stopped, bool& tooMuch, VisitLists& lists)
{
  lists = VisitLists(inputs.Area.Width, band.EndRow - band.FirstRow);
  StateScope state(window);
  Viewport part{ 0, band.FirstRow, inputs.Area.Width, band.EndRow - band.FirstRow };
  for (int visit = 0; part.Width > 0 && part.Height > 0; ++visit)
  {
    if (visit == MostVisits)
    {
      return "A ray enters the mesh of a process more than 65535 times, which is more than can be "
             "told to the others. Give each process cells that lie together.";
    }
    // The first visit reads nothing of the other target, but the GL wants textures to be bound.
    FloatTarget& target = this->Targets[visit % 2];
    FloatTarget& before = this->Targets[(visit + 1) % 2];
    std::string error = before.bind(window, inputs.Area.Width, inputs.Area.Height, Colors);
    error =
      error.empty() ? target.bind(window, inputs.Area.Width, inputs.Area.Height, Colors) : error;
    if (!error.empty())
    {
      return error;
    }
    VisitInputs visits;
    visits.AtOnce = atOnce;
    visits.Part = part;
    visits.IsFirst = visit == 0;
    visits.NextEntry = before.color(2);
    visits.RaySoFar = before.color(3);
    MarchInputs marched = inputs;
    marched.Visits = &visits;
    marched.ByCompute = false;
    error = march.drawApart(window, target, marched, this->Tiles, progress, stopped);
    this->Draws += this->Tiles.numberOfTiles();
    if (!error.empty() || stopped)
    {
      return error;
    }
    part = this->take(window, target, inputs, part, band, lists);
    if (lists.bytes() > mostBytes)
    {
      tooMuch = true;
      return {};
    }
  }
  lists.finish();
  return {};
}

// Take the visits of a part. Returns the part in which rays enter again.
Viewport VisitPass::take(vtkOpenGLRenderWindow* window, const FloatTarget& target,
  const MarchInputs& inputs, const Viewport& part, const Band& band, VisitLists& lists) const
{
  const std::vector<float> depths = target.read(window, 0, part);
  const std::vector<float> colors = target.read(window, 1, part);
  const std::vector<float> next = target.read(window, 2, part);
  Viewport again;
  std::size_t i = 0;
  for (int y = part.Y; y < part.Y + part.Height; ++y)
  {
    for (int x = part.X; x < part.X + part.Width; ++x, i += 4)
    {
      // Begin and end, which are both 0 where nothing was drawn; transmittance; error.
      const float* of = &depths[i];
      const float* color = &colors[i];
      const Visit visit{ of[0], of[1], { { color[0], color[1], color[2], of[2] } }, of[3] };
      if (visit.End > visit.Begin && showsSomething(visit, inputs.Key.Blend))
      {
        lists.add(static_cast<std::uint32_t>((y - band.FirstRow) * lists.width() + x), visit);
      }
      if (next[i + 1] > 0 || next[i + 2] > 0)
      {
        addPixel(x, y, again);
      }
    }
  }
  return again;
}

void VisitPass::release(vtkWindow* window)
{
  for (FloatTarget& target : this->Targets)
  {
    target.release(window);
  }
  this->expectChange();
}

} // namespace tetmarch
