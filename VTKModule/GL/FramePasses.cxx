// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/FramePasses.h"

#include "Caching/WithinMemory.h"
#include "Frame/FrameStages.h"
#include "GL/VolumeTextures.h"
#include "Rays/RayPoints.h"

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

} // namespace

std::string FramePasses::draw(vtkOpenGLRenderWindow* window, MarchInputs inputs,
  const Fingerprint& lightVersion, bool diagnostics, const MeasureView* view, BoundaryView boundary,
  double sampleDistance, const Progress& progress, bool& stopped)
{
  this->clear();
  const bool coarse = sampleDistance > 1;
  const bool apart = coarse || inputs.ByCompute;
  this->releaseUnused(window, inputs, diagnostics, view, boundary, apart);
  this->Pieces.release(window);
  this->noteVariant(inputs);
  std::string error = this->updateLight(window, lightVersion, progress, inputs, stopped);
  if (!error.empty() || stopped)
  {
    return error;
  }
  const Viewport area = inputs.Area;
  coarsen(sampleDistance, inputs);
  error = this->findRays(window, area, inputs);
  if (boundary != BoundaryView::None)
  {
    error =
      error.empty() ? this->Boundary.draw(window, inputs, boundary, progress, stopped) : error;
    this->Draws = error.empty() ? this->Boundary.numberOfDraws() : 0;
    return error;
  }
  if (error.empty() && (diagnostics || view))
  {
    error = this->Counted.collect(window, this->March, inputs, progress, stopped);
    this->Draws = view && error.empty() ? this->Counted.numberOfDraws() : 0;
  }
  if (!error.empty() || stopped)
  {
    return error;
  }
  if (view)
  {
    fitTable(*view, this->Counted.measures());
    return this->Shown.draw(window, inputs.Area, this->Counted.measuresTexture(), *view);
  }
  error = apart ? this->Apart.draw(window, area, this->March, inputs, progress, stopped)
                : this->March.draw(window, inputs, this->Tiles, progress, stopped);
  this->Draws = apart ? this->Apart.numberOfDraws() : this->Tiles.numberOfTiles();
  return error;
}

std::string FramePasses::drawTogether(vtkOpenGLRenderWindow* window, MarchInputs inputs,
  const Fingerprint& lightVersion, double sampleDistance, std::string before, SharedPicture& shared,
  const Progress& progress, bool& stopped)
{
  this->clear();
  this->releaseUnused(window, inputs, false, nullptr, BoundaryView::None, true);
  this->noteVariant(inputs);
  PartStatus own;
  own.Error = std::move(before);
  const Viewport area = inputs.Area;
  // The other processes wait for this one, whatever happens here.
  const std::string shortage = withinMemory("drawing",
    [&]
    {
      if (own.Error.empty() && shared.HasPiece)
      {
        own.Error = this->updateLight(window, lightVersion, progress, inputs, own.Stopped);
      }
      coarsen(sampleDistance, inputs);
      if (own.Error.empty())
      {
        own.Error = this->findRays(window, area, inputs);
      }
    });
  own.Error = shortage.empty() ? own.Error : shortage;
  if (inputs.Key.OpaqueDepth)
  {
    own.Error = this->shareDepths(window, area, *shared.Processes, own.Error);
    inputs.Depths = this->Opaque.texture();
  }
  const std::string error = this->Pieces.draw(
    window, area, this->March, inputs, own, shared, this->Apart, progress, stopped);
  this->Draws = this->Pieces.numberOfDraws();
  return error;
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

std::string FramePasses::updateLight(vtkOpenGLRenderWindow* window, const Fingerprint& lightVersion,
  const Progress& progress, MarchInputs& inputs, bool& stopped)
{
  if (!inputs.Key.hasVertexLight())
  {
    return {};
  }
  std::string error = this->Light.update(window, inputs,
    inputs.Stages->effects().data().VertexStarts.size(), lightVersion, progress, stopped);
  if (error.empty() && !stopped)
  {
    inputs.VertexLight = this->Light.texture();
  }
  return error;
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

std::string FramePasses::pick(vtkOpenGLRenderWindow* window, MarchInputs inputs,
  const Viewport& part, const Progress& progress, bool& stopped, std::vector<PickedPoint>& points)
{
  std::string error = this->findRays(window, inputs.Area, inputs);
  if (error.empty())
  {
    error = this->Picking.pick(window, inputs, part, progress, stopped, points);
  }
  if (!this->LastKey.OpaqueDepth) // picks use depths even if the picture does not
  {
    this->Opaque.release(window);
  }
  return error;
}

void FramePasses::releaseUnused(vtkWindow* window, const MarchInputs& inputs, bool diagnostics,
  const MeasureView* view, BoundaryView boundary, bool apart)
{
  const VariantKey& key = inputs.Key;
  if (!key.EntryLists)
  {
    inputs.Volume->releaseEntries(window);
  }
  if (!key.OpaqueDepth)
  {
    this->Opaque.release(window);
  }
  if (!apart || view || boundary != BoundaryView::None)
  {
    this->Apart.release(window);
  }
  if (!key.hasVertexLight())
  {
    this->Light.release(window);
  }
  if (!view)
  {
    this->Shown.release(window);
  }
  if (boundary == BoundaryView::None)
  {
    this->Boundary.release();
  }
  else
  {
    this->March.release();
  }
  if ((!view && !diagnostics) || boundary != BoundaryView::None)
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
