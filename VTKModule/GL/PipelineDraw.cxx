// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The last stage of a frame: the variant that it needs, and drawing; and the same by the CPU.
#include "GL/Pipeline.h"

#include "Caching/WithinMemory.h"
#include "GL/ContentOf.h"
#include "GL/Driver.h"
#include "GL/ErrorQueue.h"
#include "GL/FirstColorOnly.h"
#include "GL/PredicateCheck.h"
#include "GL/RayList.h"
#include "Reference/RayTrace.h"
#include "Variants/SamplerCount.h"

#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <sstream>

namespace tetmarch
{

// The viewport that the renderer, or the render pass that called, has set.
Viewport Pipeline::currentViewport() const
{
  std::array<int, 4> area{};
  this->Window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, area.data());
  return { area[0], area[1], area[2], area[3] };
}

bool Pipeline::endsRays(vtkRenderer* renderer) const
{
  return this->Stages.camera().CutsFarPlane || mayHaveOpaqueGeometry(renderer);
}

// Lattices are marched through without it.
std::string Pipeline::findPredicate(vtkOpenGLRenderWindow* window)
{
  if (this->PredicateIsKnown || this->Stages.volume().isStructured())
  {
    return {};
  }
  const std::string error = tetmarch::findPredicate(window, this->HasFma);
  this->PredicateIsKnown = error.empty();
  return error;
}

bool Pipeline::boundsCurvedCells(const DrawOptions& options) const
{
  return (options.Diagnostics || options.View) && isAny(this->Stages.departure());
}

VariantKey Pipeline::keyOf(
  const DrawOptions& options, vtkRenderer* renderer, const Viewport& area) const
{
  VariantKey key;
  this->Stages.setBits(key, double(area.Width) * area.Height);
  this->Textures.setBits(key);
  key.OpaqueDepth = options.RaysEnd || this->endsRays(renderer);
  key.HasFma = this->HasFma;
  key.Peeled = options.Peeling != nullptr;
  key.Adaptive = options.Level.Adaptive;
  key.PointSampled = options.Level.Sampled;
  // A curved cell may be seen where its tetrahedra are transparent.
  key.VisiblePart = key.VisiblePart && !this->boundsCurvedCells(options);
  return options.Boundary == BoundaryView::None ? key.filtered() : key.ofEntries();
}

// From an eye in the mesh there are lists for rays that enter a part. Others search their entries.
VariantKey Pipeline::withEntries(VariantKey key) const
{
  if (key.VisiblePart || !this->Stages.camera().CutsNearPlane)
  {
    return key;
  }
  key.EntryLists = false;
  key.Hierarchy = !key.Structured;
  key.Reentered = false;
  return key;
}

// What the GL can't do of a picture.
std::string Pipeline::describeUnfit(const MarchInputs& inputs, int ofVisits)
{
  const VariantKey& key = inputs.Key;
  const bool searches =
    key.Hierarchy || (key.hasVertexLight() && inputs.Stages->volume().mayReenter());
  if (searches && !writesArrays())
  {
    return "Mesa's softpipe can't search for where rays enter a mesh: those from a camera inside "
           "it, and those towards lights. Choose another driver, such as llvmpipe "
           "(GALLIUM_DRIVER=llvmpipe), or draw from outside, without shadows and ambient "
           "occlusion.";
  }
  const int needed = samplersOf(key) + ofVisits;
  const int most = textureUnits(inputs.ByCompute);
  return needed <= most
           ? std::string()
           : "This picture needs " + std::to_string(needed) +
               " textures at once, but the GL lets a shader read " + std::to_string(most) +
               ". Switch off one of these: depth peeling, shadows, gradient opacity, "
               "shading; or draw fewer components.";
}

Fingerprint Pipeline::lightVersion(const MarchInputs& inputs) const
{
  Fingerprint version = this->Stages.lightVersion(inputs.Key);
  version.push_back(inputs.ByCompute ? 1 : 0);
  return version;
}

MarchInputs Pipeline::inputsOf(
  const DrawOptions& options, vtkRenderer* renderer, const Viewport& area)
{
  MarchInputs inputs;
  inputs.ByCompute = !options.Peeling && options.Boundary == BoundaryView::None &&
                     marchesByCompute(options.Stage, this->Compute);
  inputs.Area = area;
  const int ofVisits = options.Shared ? SamplersOfVisits : 0;
  const int units = textureUnits(inputs.ByCompute);
  const int ofBounds = this->boundsCurvedCells(options) ? 1 : 0; // variations of the functions
  inputs.Key = this->withEntries(
    fittedTo(units - ofVisits - ofBounds, this->withEntries(this->keyOf(options, renderer, area))));
  const bool fits = samplersOf(inputs.Key) + SamplersOfRayLists <= units &&
                    std::int64_t(area.Width) * area.Height < RayList::MostPixels;
  inputs.PixelTolerance = fits && !options.Shared ? options.PixelTolerance : 0;
  inputs.CountsRays = options.Diagnostics || options.View;
  inputs.Stages = &this->Stages;
  inputs.Volume = &this->Textures;
  inputs.Tables = &this->TablesOnGpu;
  inputs.Effects = &this->EffectsOnGpu;
  inputs.Level = this->Stages.levelFor(options.Level);
  inputs.ColorWindow = options.ColorWindow;
  inputs.Peeling = options.Peeling;
  inputs.MostSecondsPerDraw = options.MostSecondsPerDraw;
  inputs.MostLightSeconds = options.MostLightSeconds;
  inputs.LightVersion = this->lightVersion(inputs);
  inputs.Content = contentOf(this->Stages.contentVersion(), inputs, renderer);
  return inputs;
}

// A progress observer may have released graphics resources that were bound; VTK's records of the
// state then bound them again, which is an error of the GL.
void Pipeline::forgetErrorsOfReleasing(vtkOpenGLRenderWindow* window)
{
  if (this->Window != window)
  {
    clearErrors();
  }
}

// What is wrong with the view that is asked for instead of the picture, and what to choose.
std::string Pipeline::describeBadView(const DrawOptions& options) const
{
  if (options.Boundary != BoundaryView::None && this->Stages.volume().isStructured())
  {
    return "The view mode shows boundary faces, but images, rectilinear grids and the leaves of "
           "adaptive meshes have none: rays enter them by the six sides of their box. Choose "
           "another one, such as SetViewModeToCells() or SetViewModeToPicture().";
  }
  if (options.View && options.View->What == Measure::ErrorBound && options.Level.Sampled &&
      this->Stages.blending().isComposite())
  {
    return "The view mode shows error bounds, but the accuracy level is Sampled, and what lies "
           "between samples has none. Choose another level, such as SetAccuracyLevelToDefault(), "
           "or another view mode; CompareWithGroundTruth() measures the errors of samples.";
  }
  return options.View ? describeBadRange(*options.View) : std::string();
}

// What is wrong with the options for a picture of this volume.
std::string Pipeline::describeBadOptions(const DrawOptions& options) const
{
  const std::string badView = this->describeBadView(options);
  const std::string badSamples =
    options.Level.Sampled ? this->Stages.describeBadSamples() : std::string();
  return !badView.empty()      ? badView
         : !badSamples.empty() ? badSamples
         : options.Stage == ShaderStage::Compute && !this->Compute.Exists
           ? "The shader stage is Compute, but this GL has no compute shaders: they need OpenGL "
             "4.3. Choose SetShaderStageToAutomatic()."
           : std::string();
}

// What the stages have not prepared, since most variants don't need it.
std::string Pipeline::prepareSearch(vtkOpenGLRenderWindow* window, const VariantKey& key)
{
  if (!key.Hierarchy)
  {
    return {};
  }
  const std::string error = this->Stages.prepareEntrySearch();
  return error.empty() ? this->upload(window) : error;
}

StageResult Pipeline::draw(vtkOpenGLRenderWindow* window, vtkRenderer* renderer,
  const DrawOptions& options, const Progress& progress)
{
  const Viewport area = this->currentViewport();
  this->Content = this->Stages.contentVersion();
  if (area.Width <= 0 || area.Height <= 0)
  {
    return {};
  }
  const std::string bad = this->describeBadOptions(options);
  if (!bad.empty())
  {
    return { bad };
  }
  MarchInputs inputs = this->inputsOf(options, renderer, area);
  const std::string missing = this->prepareSearch(window, inputs.Key);
  if (!missing.empty())
  {
    return { missing };
  }
  this->PixelTolerance = inputs.PixelTolerance;
  this->Content.push_back(static_cast<std::uintptr_t>(area.Width));
  this->Content.push_back(static_cast<std::uintptr_t>(area.Height));

  const FirstColorOnly picture(!options.Peeling); // peels are drawn into several colours on purpose
  // A progress observer may release graphics resources during the frame.
  const auto goOn = [&](double share) { return progress(share) && this->Window == window; };
  const DrawContext context{ window, goOn };
  StageResult result{ describeUnfit(inputs, options.Shared ? SamplersOfVisits : 0) };
  std::string shortage = withinMemory("drawing",
    [&]
    {
      result.Error = result.Error.empty()
                       ? this->EffectsOnGpu.update(window, this->Stages.effects(), inputs.Key)
                       : result.Error;
    });
  result.Error = shortage.empty() ? result.Error : shortage;
  shortage = withinMemory("drawing",
    [&]
    {
      result = options.Shared
                 ? this->Passes.drawDistributed(context, inputs, options, result.Error)
                 : result.then([&] { return this->Passes.draw(context, inputs, options); });
    });
  this->forgetErrorsOfReleasing(window);
  if (!shortage.empty())
  {
    this->Passes.clear();
    result = { shortage };
  }
  if (result.isDone())
  {
    const bool isWhole = !options.Peeling && !options.Shared && options.SampleDistance <= 1;
    this->Area = isWhole ? inputs.Area : Viewport();
  }
  return result;
}

void Pipeline::finish() const { glFinish(); }

} // namespace tetmarch
