// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/FramePasses.h"

#include "GL/MarchSource.h"
#include "Rays/RayPoints.h"

#include "vtkOpenGLRenderWindow.h"

namespace tetmarch
{

std::string FramePasses::draw(vtkOpenGLRenderWindow* window, MarchInputs inputs,
  const Fingerprint& lightVersion, bool diagnostics, const MeasureView* view, BoundaryView boundary,
  double sampleDistance, const Progress& progress, bool& stopped)
{
  this->clear();
  const bool coarse = sampleDistance > 1;
  const bool apart = coarse || inputs.ByCompute;
  this->releaseUnused(window, inputs, diagnostics, view, boundary, apart);
  const bool otherStage = inputs.ByCompute != this->LastByCompute;
  if (otherStage)
  {
    this->March.release(); // what the other stage needs
    this->Light.releasePrograms();
  }
  this->ChangedVariant = otherStage || !(inputs.Key == this->LastKey);
  if (this->ChangedVariant)
  {
    this->expectChange();
    this->LastKey = inputs.Key;
    this->LastByCompute = inputs.ByCompute;
  }
  std::string error;
  if (inputs.Key.hasVertexLight())
  {
    error = this->Light.update(
      window, inputs, inputs.EffectValues->VertexStarts.size(), lightVersion, progress, stopped);
    if (!error.empty() || stopped)
    {
      return error;
    }
    inputs.VertexLight = this->Light.texture();
  }
  const Viewport area = inputs.Area;
  if (coarse)
  {
    inputs.Area = coarseArea(area, sampleDistance);
    inputs.DepthsPerPixel = { { float(area.Width) / float(inputs.Area.Width),
      float(area.Height) / float(inputs.Area.Height) } };
  }
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

// Find where the rays of pixels may enter, and where they end by the depths of the window.
std::string FramePasses::findRays(
  vtkOpenGLRenderWindow* window, const Viewport& depths, MarchInputs& inputs)
{
  std::string error;
  if (inputs.Key.EntryLists)
  {
    error = inputs.Source->listEntries(window, inputs.Key, inputs.Area, *inputs.Camera);
  }
  inputs.RayPoints = rayPoints(*inputs.Camera, inputs.Source->frame());
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
    inputs.Source->releaseEntries(window);
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

void FramePasses::expectChange()
{
  this->Tiles.expectChange();
  this->Counted.expectChange();
  this->Boundary.expectChange();
  this->Apart.expectChange();
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
  this->Picking.release();
  this->expectChange();
}

} // namespace tetmarch
