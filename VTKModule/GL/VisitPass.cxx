// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/VisitPass.h"

#include "GL/StateScope.h"

namespace tetmarch
{
namespace
{

constexpr int Colors = 3;         // as passes/visit.frag.glsl writes them
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

} // namespace

std::string VisitPass::collect(vtkOpenGLRenderWindow* window, MarchPass& march,
  const MarchInputs& inputs, const Band& band, float atOnce, std::uint64_t mostBytes,
  const Progress& progress, bool& stopped, bool& tooMuch, VisitLists& lists)
{
  lists = VisitLists(inputs.Area.Width, band.EndRow - band.FirstRow);
  StateScope state(window);
  bool goesOn = true;
  for (int visit = 0; goesOn; ++visit)
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
    error = error.empty()
              ? target.bind(window, inputs.Area.Width, inputs.Area.Height, Colors)
              : error;
    if (!error.empty())
    {
      return error;
    }
    VisitInputs visits;
    visits.AtOnce = atOnce;
    visits.FirstRow = band.FirstRow;
    visits.EndRow = band.EndRow;
    visits.IsFirst = visit == 0;
    visits.Before = before.color(1);
    visits.NextEntry = before.color(2);
    MarchInputs marched = inputs;
    marched.Visits = &visits;
    marched.ByCompute = false;
    error = march.drawApart(window, target, marched, this->Tiles, progress, stopped);
    this->Draws += this->Tiles.numberOfTiles();
    if (!error.empty() || stopped)
    {
      return error;
    }
    goesOn = this->take(window, target, inputs, band, lists);
    if (lists.bytes() > mostBytes)
    {
      tooMuch = true;
      return {};
    }
  }
  lists.finish();
  return {};
}

// Whether some ray enters again.
bool VisitPass::take(vtkOpenGLRenderWindow* window, const FloatTarget& target,
  const MarchInputs& inputs, const Band& band, VisitLists& lists) const
{
  const std::vector<float> depths = target.read(window, 0);
  const std::vector<float> colors = target.read(window, 1);
  const std::vector<float> next = target.read(window, 2);
  const std::size_t row = 4 * static_cast<std::size_t>(inputs.Area.Width);
  const std::size_t begin = row * band.FirstRow;
  bool goesOn = false;
  for (std::size_t i = begin; i < row * band.EndRow; i += 4)
  {
    // Begin and end, which are both 0 where nothing was drawn; transmittance; error.
    const float* part = &depths[i];
    const float* color = &colors[i];
    const Visit visit{ part[0], part[1], { { color[0], color[1], color[2], part[2] } }, part[3] };
    if (visit.End > visit.Begin && showsSomething(visit, inputs.Key.Blend))
    {
      lists.add(static_cast<std::uint32_t>((i - begin) / 4), visit);
    }
    goesOn = goesOn || next[i + 1] > 0 || next[i + 2] > 0;
  }
  return goesOn;
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
