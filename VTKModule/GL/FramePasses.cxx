// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/FramePasses.h"

#include "Caching/WithinMemory.h"
#include "Frame/FrameStages.h"
#include "GL/VolumeTextures.h"
#include "View/RayPoints.h"

#include "vtkOpenGLRenderWindow.h"

namespace tetmarch
{

namespace
{

// Take fewer rays than the area has pixels.
void coarsen(double sampleDistance, MarchInputs& inputs)
{
  const Viewport area = inputs.Area;
  if (sampleDistance > 1)
  {
    inputs.Area = coarseArea(area, sampleDistance);
    inputs.DepthsPerPixel = { { float(area.Width) / float(inputs.Area.Width),
      float(area.Height) / float(inputs.Area.Height) } };
  }
}

// Whether the picture is marched into a target of its own.
bool isApart(const MarchInputs& inputs, const DrawOptions& options)
{
  return options.SampleDistance > 1 || inputs.ByCompute || inputs.PixelTolerance > 0;
}

} // namespace

StageResult FramePasses::draw(
  const DrawContext& context, MarchInputs inputs, const DrawOptions& options)
{
  this->clear();
  const bool apart = isApart(inputs, options);
  this->releaseUnused(context.Window, inputs, options, apart);
  this->Pieces.release(context.Window);
  this->noteVariant(inputs);
  const Viewport area = inputs.Area;
  return this->updateLight(context, inputs)
    .then(
      [&]
      {
        coarsen(options.SampleDistance, inputs);
        return StageResult{ this->findRays(context.Window, area, inputs) };
      })
    .then([&] { return this->drawSeen(context, area, inputs, options); });
}

// The picture, or a view instead.
StageResult FramePasses::drawSeen(const DrawContext& context, const Viewport& area,
  const MarchInputs& inputs, const DrawOptions& options)
{
  StageResult result;
  if (options.Boundary != BoundaryView::None)
  {
    result = this->Boundary.draw(context, inputs, options.Boundary);
    this->Draws = result.Error.empty() ? this->Boundary.numberOfDraws() : 0;
    return result;
  }
  const MeasureView* view = options.View;
  if (options.Diagnostics || view)
  {
    result = this->Counted.collect(context, this->March, inputs);
    this->Draws = view && result.Error.empty() ? this->Counted.numberOfDraws() : 0;
  }
  if (!view)
  {
    result = result.then([&] { return this->drawPicture(context, area, inputs, options); });
  }
  else if (inputs.PixelTolerance > 0)
  {
    result = result.then(
      [&] { return this->Apart.adaptive().march(context, this->March, inputs, false); });
  }
  if (inputs.CountsRays && inputs.PixelTolerance > 0)
  {
    result = result.then(
      [&] {
        return StageResult{ this->Counted.take(context.Window, this->Apart.adaptive(), inputs) };
      });
  }
  return !view ? result
               : result.then(
                   [&]
                   {
                     fitTable(*view, this->Counted.measures());
                     return StageResult{ this->Shown.draw(
                       context.Window, inputs.Area, this->Counted.measuresTexture(), *view) };
                   });
}

StageResult FramePasses::drawPicture(const DrawContext& context, const Viewport& area,
  const MarchInputs& inputs, const DrawOptions& options)
{
  const bool apart = isApart(inputs, options);
  const StageResult result = apart ? this->Apart.draw(context, area, this->March, inputs)
                                   : this->March.draw(context, inputs, this->Tiles);
  this->Draws = apart ? this->Apart.numberOfDraws() : this->Tiles.numberOfTiles();
  return result;
}

StageResult FramePasses::drawDistributed(const DrawContext& context, MarchInputs inputs,
  const DrawOptions& options, const std::string& before)
{
  SharedPicture& shared = *options.Shared;
  this->clear();
  this->releaseUnused(context.Window, inputs, options, true);
  this->noteVariant(inputs);
  const Viewport area = inputs.Area;
  StageResult own{ before };
  // The other processes wait for this one, whatever happens here.
  const std::string shortage = withinMemory("drawing",
    [&]
    {
      if (shared.HasPiece)
      {
        own = own.then([&] { return this->updateLight(context, inputs); });
      }
      coarsen(options.SampleDistance, inputs);
      own.Error = own.Error.empty() ? this->findRays(context.Window, area, inputs) : own.Error;
    });
  own.Error = shortage.empty() ? own.Error : shortage;
  if (inputs.Key.OpaqueDepth)
  {
    own.Error = this->shareDepths(context.Window, area, *shared.Processes, own.Error);
    inputs.Depths = this->Opaque.texture();
  }
  StageResult result =
    this->Pieces.draw({ context, this->March, inputs, own, shared }, area, this->Apart);
  this->Draws = this->Pieces.numberOfDraws();
  return result;
}

// Opaque geometry of any process ends the rays of all.
std::string FramePasses::shareDepths(
  vtkOpenGLRenderWindow* window, const Viewport& area, Group& group, std::string before)
{
  std::vector<float> depths = before.empty()
                                ? this->Opaque.read(window)
                                : std::vector<float>(std::size_t(area.Width) * area.Height, 1.0f);
  group.keepLeast(depths);
  return before.empty() ? this->Opaque.replace(window, depths) : before;
}

void FramePasses::noteVariant(const MarchInputs& inputs)
{
  const bool otherStage = inputs.ByCompute != this->LastByCompute;
  if (otherStage)
  {
    this->March.release(); // what the other stage needs
    this->Light.releasePrograms();
  }
  this->ChangedVariant = otherStage || !(inputs.Key == this->LastKey);
  if (this->ChangedVariant)
  {
    this->LastKey = inputs.Key;
    this->LastByCompute = inputs.ByCompute;
  }
}

StageResult FramePasses::updateLight(const DrawContext& context, MarchInputs& inputs)
{
  if (!inputs.Key.hasVertexLight())
  {
    return {};
  }
  StageResult result = this->Light.update(context, inputs);
  if (result.isDone())
  {
    inputs.VertexLight = this->Light.texture();
  }
  return result;
}

// Find where the rays of pixels may enter, and where they end by the depths of the window.
std::string FramePasses::findRays(
  vtkOpenGLRenderWindow* window, const Viewport& depths, MarchInputs& inputs)
{
  std::string error;
  if (inputs.Key.EntryLists)
  {
    error = inputs.Volume->listEntries(window, inputs.Key, inputs.Area, inputs.Stages->camera());
  }
  inputs.RayPoints = rayPoints(inputs.Stages->camera(), inputs.Stages->volume().frame());
  if (error.empty() && inputs.Key.OpaqueDepth)
  {
    error = this->Opaque.capture(window, depths);
    inputs.Depths = this->Opaque.texture();
  }
  return error;
}

StageResult FramePasses::pick(const DrawContext& context, MarchInputs inputs, const Viewport& part,
  std::vector<PickedPoint>& points)
{
  StageResult result{ this->findRays(context.Window, inputs.Area, inputs) };
  result = result.then([&] { return this->Picking.pick(context, inputs, part, points); });
  if (!this->LastKey.OpaqueDepth) // picks use depths even if the picture does not
  {
    this->Opaque.release(context.Window);
  }
  return result;
}

void FramePasses::releaseUnused(
  vtkWindow* window, const MarchInputs& inputs, const DrawOptions& options, bool apart)
{
  const bool boundary = options.Boundary != BoundaryView::None;
  const VariantKey& key = inputs.Key;
  if (!key.EntryLists)
  {
    inputs.Volume->releaseEntries(window);
  }
  if (!key.OpaqueDepth)
  {
    this->Opaque.release(window);
  }
  if (!apart || boundary || (options.View && !(inputs.PixelTolerance > 0)))
  {
    this->Apart.release(window);
  }
  if (!key.hasVertexLight())
  {
    this->Light.release(window);
  }
  if (!options.View)
  {
    this->Shown.release(window);
  }
  if (boundary)
  {
    this->March.release();
  }
  else
  {
    this->Boundary.release();
  }
  const bool counts = options.View || (options.Diagnostics && !options.Shared);
  if (!counts || boundary)
  {
    this->Counted.release(window);
  }
}

void FramePasses::forgetTimes()
{
  this->Tiles.forget();
  this->Counted.forgetTimes();
  this->Boundary.forgetTimes();
  this->Apart.forgetTimes();
  this->Pieces.forgetTimes();
}

void FramePasses::clear()
{
  this->Counted.clear();
  this->Draws = 0;
}

void FramePasses::release(vtkWindow* window)
{
  this->Opaque.release(window);
  this->Light.release(window);
  this->March.release();
  this->Counted.release(window);
  this->Shown.release(window);
  this->Boundary.release();
  this->Apart.release(window);
  this->Pieces.release(window);
  this->Picking.release();
  this->forgetTimes();
}

} // namespace tetmarch
