// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/AdaptivePicture.h"

#include "Frame/FrameStages.h"
#include "GL/FullViewDraw.h"
#include "GL/StateScope.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tetmarch
{
namespace
{

std::string makeRoom(vtkOpenGLRenderWindow* window, FloatTarget& target, const Viewport& area)
{
  const StateScope state(window); // it does not stay bound
  return target.bind(window, area.Width, area.Height, 1, TargetFormat::Share16);
}

// The pixels from the lower to the upper end of an interval of the screen, from a sample of the
// first grid on; those of the whole side if an end is not finite.
std::array<int, 2> pixelsOf(double low, double high, int side, int spacing)
{
  const auto pixel = [&](double x) { return std::clamp(0.5 * (x + 1) * side, 0.0, double(side)); };
  if (!(std::abs(low) < HUGE_VAL) || !(std::abs(high) < HUGE_VAL))
  {
    return { { 0, side } };
  }
  const int begin = std::min(static_cast<int>(pixel(low)), side - 1) / spacing * spacing;
  return { { begin, std::max(1, static_cast<int>(std::ceil(pixel(high))) - begin) } };
}

} // namespace

// Where the volume may be seen.
Viewport AdaptivePicture::partOf(const MarchInputs& inputs)
{
  const ScreenBox box = inputs.Content.box();
  const auto x = pixelsOf(box.Low[0], box.High[0], inputs.Area.Width, MostSpacing);
  const auto y = pixelsOf(box.Low[1], box.High[1], inputs.Area.Height, MostSpacing);
  return { x[0], y[0], x[1], y[1] };
}

// The coarsest grid whose rays touch each detail of the scalars, or that of two pixels.
int AdaptivePicture::firstGridOf(const MarchInputs& inputs)
{
  const FrameStages& stages = *inputs.Stages;
  const double detail =
    stages.volume().leastDetail() * stages.camera().leastPixelsPerUnit(inputs.Area.Height);
  int i = 0;
  while (detail > 0 && i < NumberOfGrids - 2 && (MostSpacing >> i) > detail)
  {
    ++i;
  }
  return i;
}

StageResult AdaptivePicture::march(
  const DrawContext& context, MarchPass& march, const MarchInputs& inputs, bool whole)
{
  const StateScope state(context.Window);
  this->Part = whole ? Viewport{ 0, 0, inputs.Area.Width, inputs.Area.Height } : partOf(inputs);
  this->Traced.assign(inputs.CountsRays ? std::size_t(this->Part.Width) * this->Part.Height : 0, 0);
  this->First = firstGridOf(inputs);
  SampleGrid grid{ this->Part, MostSpacing >> this->First };
  StageResult result{ this->Edges.find(context.Window, inputs, this->Part, grid.Spacing) };
  result = result.then([&] { return this->traceFirst(context, march, inputs, grid, this->First); });
  for (int i = this->First + 1; i < NumberOfGrids; ++i)
  {
    result = result.then([&] { return this->refine(context, march, inputs, grid, i); });
    grid = grid.finer();
  }
  return result;
}

StageResult AdaptivePicture::traceFirst(
  const DrawContext& context, MarchPass& march, MarchInputs inputs, const SampleGrid& grid, int i)
{
  FloatTarget& picture = this->Pictures[i];
  StageResult result{ this->List.takeAll(context.Window, grid) };
  result =
    result.then([&] { return StageResult{ makeRoom(context.Window, picture, grid.area()) }; });
  inputs.List = &this->List;
  result = result.then([&] { return march.drawListed(context, picture, inputs, this->Tiles[i]); });
  return result.then([&] { return this->count(context.Window, inputs); });
}

StageResult AdaptivePicture::refine(
  const DrawContext& context, MarchPass& march, MarchInputs inputs, const SampleGrid& grid, int i)
{
  vtkOpenGLRenderWindow* window = context.Window;
  StageResult result{ this->List.find(window, grid, this->Pictures[i - 1].color(0),
    this->Edges.texture(grid), inputs.PixelTolerance) };
  inputs.List = &this->List;
  // The list does not lie in the picture as the volume does.
  inputs.Content.Corners = PictureContent().Corners;
  result =
    result.then([&] { return StageResult{ makeRoom(window, this->Listed, this->List.image()) }; });
  result =
    result.then([&] { return march.drawListed(context, this->Listed, inputs, this->Tiles[i]); });
  if (i < NumberOfGrids - 1)
  {
    result = result.then([&] { return StageResult{ this->merge(window, i) }; });
  }
  return result.then([&] { return this->count(window, inputs); });
}

std::string AdaptivePicture::merge(vtkOpenGLRenderWindow* window, int i)
{
  const Viewport area = this->List.grid().area();
  const TargetScope state(window, area.Width, area.Height);
  const std::string error =
    this->Pictures[i].bind(window, area.Width, area.Height, 1, TargetFormat::Share16);
  return error.empty() ? this->drawMerged(window, i, area) : error;
}

std::string AdaptivePicture::blend(vtkOpenGLRenderWindow* window, const Viewport& area)
{
  const Viewport part{ area.X + this->Part.X, area.Y + this->Part.Y, this->Part.Width,
    this->Part.Height };
  StateScope state(window);
  blendPremultiplied(state);
  state->vtkglViewport(part.X, part.Y, part.Width, part.Height);
  this->Pictures.back().release(window);
  return this->drawMerged(window, NumberOfGrids - 1, part);
}

// Into the bound framebuffer.
std::string AdaptivePicture::drawMerged(vtkOpenGLRenderWindow* window, int i, const Viewport& area)
{
  const std::array<int, 2> corner{ { area.X, area.Y } };
  return drawFullView(this->Draw, window, "passes/merge_rays.frag.glsl",
    { { "coarseTexture", this->Pictures[i - 1].color(0) }, { "listTexture", this->Listed.color(0) },
      { "rankTexture", this->List.ranks() } },
    [&](vtkShaderProgram* program)
    {
      this->List.setUniformsOfImage(program);
      program->SetUniform2i("corner", corner.data());
    });
}

std::string AdaptivePicture::read(vtkOpenGLRenderWindow* window, std::vector<float>& colors)
{
  const std::string error = this->makePicture(window);
  if (error.empty())
  {
    colors = this->Pictures.back().read(window, 0);
  }
  this->Pictures.back().release(window);
  return error;
}

StageResult AdaptivePicture::count(vtkOpenGLRenderWindow* window, const MarchInputs& inputs)
{
  if (inputs.CountsRays)
  {
    this->List.mark(window, this->Traced);
  }
  return {};
}

int AdaptivePicture::numberOfDraws() const
{
  return std::accumulate(this->Tiles.begin() + this->First, this->Tiles.end(), 0,
    [](int draws, const TileSchedule& tiles) { return draws + tiles.numberOfTiles(); });
}

void AdaptivePicture::forgetTimes()
{
  for (TileSchedule& tiles : this->Tiles)
  {
    tiles.forget();
  }
}

void AdaptivePicture::release(vtkWindow* window)
{
  for (FloatTarget& picture : this->Pictures)
  {
    picture.release(window);
  }
  this->Edges.release(window);
  this->List.release(window);
  this->Listed.release(window);
  this->Draw.release();
  this->Traced.clear();
}

std::size_t AdaptivePicture::bytes() const
{
  return std::accumulate(this->Pictures.begin(), this->Pictures.end(),
    this->Edges.bytes() + this->List.bytes() + this->Listed.bytes(),
    [](std::size_t bytes, const FloatTarget& picture) { return bytes + picture.bytes(); });
}

} // namespace tetmarch
