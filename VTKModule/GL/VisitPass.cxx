// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/VisitPass.h"

#include "GL/StateScope.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

// As passes/visit.frag.glsl writes them.
constexpr int ColorsOfTarget = 4;
constexpr int FirstColorOfRays = 2;
constexpr double ShareOfFewRays = 1.0 / 16; // of the pixels
constexpr int MostVisits = 65535;           // of a pixel, as they are sent
constexpr int PixelsOfRead = 1 << 16;       // read at once

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

void VisitPass::begin(const Viewport& area, const Band& band, bool hasPiece)
{
  this->Rows = band;
  this->Next = hasPiece ? NextEntries(area.Width, band.EndRow - band.FirstRow) : NextEntries();
  this->Visits = 0;
  this->Bytes = 0;
  this->Ended = 0;
}

// What is drawn into and read from.
std::string VisitPass::bind(
  vtkOpenGLRenderWindow* window, const MarchInputs& inputs, const VisitTurn& turn)
{
  const int width = inputs.Area.Width;
  if (!turn.Hidden.empty() &&
      !this->Hidden.upload(window, width, this->Rows.EndRow - this->Rows.FirstRow, 1, turn.Hidden))
  {
    return "The GPU has no room for the depths at which pieces are hidden. Close what else uses "
           "it, or make the window smaller.";
  }
  const std::string error =
    this->Rays.bind(window, width, inputs.Area.Height, ColorsOfTarget - FirstColorOfRays);
  return error.empty() ? this->Target.bind(window, width, inputs.Area.Height, ColorsOfTarget)
                       : error;
}

PartStatus VisitPass::collect(const DrawContext& context, MarchPass& march,
  const MarchInputs& inputs, const VisitTurn& turn, VisitLists& lists)
{
  vtkOpenGLRenderWindow* window = context.Window;
  StateScope state(window);
  PixelBox box = this->Next.boxOfSeen(turn.Hidden);
  PartStatus own;
  own.Error = box.Pixels == 0 ? std::string() : this->bind(window, inputs, turn);
  const double few = ShareOfFewRays * lists.width() * lists.height();
  const auto goesOn = [&](int visits)
  {
    const auto rays = static_cast<double>(box.Pixels);
    return rays > 0 && (visits < turn.MostVisits || rays <= few);
  };
  for (int visits = 0; own.Error.empty() && goesOn(visits); ++visits)
  {
    if (this->Visits == MostVisits)
    {
      own.Error =
        "A ray enters the mesh of a process more than 65535 times, which is more than can be "
        "told to the others. Give each process cells that lie together.";
      return own;
    }
    VisitInputs visit;
    visit.AtOnce = turn.AtOnce;
    visit.Part = { box.X, box.Y + this->Rows.FirstRow, box.Width, box.Height };
    visit.IsFirst = this->Visits == 0;
    visit.NextEntry = this->Rays.color(0);
    visit.RaySoFar = this->Rays.color(1);
    // The GL wants a texture to be bound, also if it has nothing to say.
    visit.KnowsHidden = !turn.Hidden.empty();
    visit.Hidden = visit.KnowsHidden ? this->Hidden.texture() : visit.RaySoFar;
    visit.FirstRow = this->Rows.FirstRow;
    MarchInputs marched = inputs;
    marched.Visits = &visit;
    marched.ByCompute = false;
    const StageResult drawn = march.drawApart(context, this->Target, marched, this->Tiles);
    this->Draws += this->Tiles.numberOfTiles();
    if (!drawn.isDone())
    {
      own.Error = drawn.Error;
      own.Stopped = drawn.Stopped;
      return own;
    }
    ++this->Visits;
    this->take(window, inputs, visit.Part, lists);
    own.TooMuch = this->Bytes + lists.bytes() > turn.MostBytes;
    if (own.TooMuch)
    {
      return own;
    }
    box = this->Next.boxOfSeen(turn.Hidden);
  }
  if (turn.HiddenIsSure)
  {
    this->endHidden(turn.Hidden);
  }
  this->Bytes += lists.bytes();
  lists.finish();
  return own;
}

// Take the visits of a part, and where its rays enter again: some rows at once, so that what is
// read stays in the caches of the processor.
void VisitPass::take(
  vtkOpenGLRenderWindow* window, const MarchInputs& inputs, const Viewport& part, VisitLists& lists)
{
  const int rows = std::max(PixelsOfRead / part.Width, 1);
  for (int row = 0; row < part.Height; row += rows)
  {
    this->takeRows(window, inputs,
      { part.X, part.Y + row, part.Width, std::min(rows, part.Height - row) }, lists);
  }
  for (int i = FirstColorOfRays; i < ColorsOfTarget; ++i)
  {
    this->Target.copy(window, i, this->Rays, i - FirstColorOfRays, part);
  }
}

void VisitPass::takeRows(
  vtkOpenGLRenderWindow* window, const MarchInputs& inputs, const Viewport& part, VisitLists& lists)
{
  this->Target.read(window, 0, part, this->Depths);
  this->Target.read(window, 1, part, this->Colors);
  std::size_t i = 0;
  for (int y = part.Y; y < part.Y + part.Height; ++y)
  {
    for (int x = part.X; x < part.X + part.Width; ++x, i += 4)
    {
      const auto pixel = static_cast<std::uint32_t>((y - this->Rows.FirstRow) * lists.width() + x);
      // Begin and end, which are both 0 where nothing was drawn; transmittance; error.
      const float* of = &this->Depths[i];
      const float* color = &this->Colors[i];
      const Visit visit{ of[0], of[1], { { color[0], color[1], color[2], of[2] } }, of[3] };
      if (visit.End > visit.Begin && showsSomething(visit, inputs.Key.Blend))
      {
        lists.add(pixel, visit);
      }
      const float next = color[3]; // depth of the next entry; 0: there is none
      if (next != 0)
      {
        this->Next.set(pixel, next);
      }
      else
      {
        this->Next.end(pixel);
      }
    }
  }
}

void VisitPass::release(vtkWindow* window)
{
  this->Target.release(window);
  this->Rays.release(window);
  this->Hidden.release(window);
  this->forgetTimes();
}

} // namespace tetmarch
