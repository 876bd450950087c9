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
  return this->Camera.CutsFarPlane || mayHaveOpaqueGeometry(renderer);
}

// Lattices are marched through without it.
std::string Pipeline::findPredicate(vtkOpenGLRenderWindow* window)
{
  VariantKey key;
  this->Source.setBits(key, this->Camera);
  if (this->PredicateIsKnown || key.Structured)
  {
    return {};
  }
  const std::string error = tetmarch::findPredicate(window, this->HasFma);
  this->PredicateIsKnown = error.empty();
  return error;
}

VariantKey Pipeline::keyOf(
  const DrawOptions& options, vtkRenderer* renderer, const Viewport& area) const
{
  VariantKey key;
  this->Source.setBits(key, this->Camera);
  key.OpaqueDepth = options.RaysEnd || this->endsRays(renderer);
  key.HasFma = this->HasFma;
  key.Peeled = options.Peeling != nullptr;
  key.Adaptive = options.Level.Adaptive;
  key.PointSampled = options.Level.Sampled;
  key.TransparentRanges = this->PassesCells.isOn();
  key.ConstantColor = this->Tables.first().Traits.ConstantColor;
  key.Clipped = this->Cut.cuts();
  key.Cropped = this->Cut.Cropped;
  key.NanShown = this->NanShown;
  this->Blend.setBits(key);
  this->Tables.components().setBits(key);
  this->Effects.setBits(key, double(area.Width) * area.Height);
  return options.Boundary == BoundaryView::None ? key.filtered() : key.ofEntries();
}

// What the GL can't do of a picture.
std::string Pipeline::describeUnfit(const MarchInputs& inputs, int ofVisits)
{
  const VariantKey& key = inputs.Key;
  const bool searches = key.Hierarchy || (key.hasVertexLight() && inputs.Source->mayReenter());
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

// The version of the light at vertices. The first word is that of the geometry.
Fingerprint Pipeline::lightVersion(const MarchInputs& inputs) const
{
  const VariantKey& key = inputs.Key;
  const LightUniforms& lights = this->Effects.data().Lights;
  Fingerprint version = this->Source.version();
  version.push_back(static_cast<std::uintptr_t>(this->Tables.record().Runs));
  addAll(version, this->Camera.ThicknessMatrix);
  for (const auto& source : lights.ShadowSources)
  {
    addAll(version, source);
  }
  add(version, lights.Reach);
  add(version, lights.OcclusionRadius);
  version.push_back(static_cast<std::uintptr_t>(lights.OcclusionDirections));
  version.push_back(key.SampledShadows ? 1 : 0); // sampled along rays, lights are not kept
  version.push_back(key.NanShown ? 1 : 0);
  version.push_back(inputs.ByCompute ? 1 : 0);
  add(version, this->Effects.gradientOpacityVersion());
  add(version, this->Effects.opaqueShadowsVersion());
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
  inputs.Key =
    fittedTo(textureUnits(inputs.ByCompute) - ofVisits, this->keyOf(options, renderer, area));
  inputs.Camera = &this->Camera;
  inputs.Cut = &this->Cut;
  inputs.Source = &this->Source;
  inputs.Tables = &this->TablesOnGpu;
  inputs.Table = &this->Tables.first();
  inputs.Range = this->Source.range();
  inputs.Parts = &this->Tables.components();
  inputs.Level = this->levelFor(options.Level);
  inputs.Blend = &this->Blend;
  inputs.Effects = &this->EffectsOnGpu;
  inputs.EffectValues = &this->Effects.data();
  inputs.ColorWindow = options.ColorWindow;
  inputs.Peeling = options.Peeling;
  inputs.MostSecondsPerDraw = options.MostSecondsPerDraw;
  inputs.MostLightSeconds = options.MostLightSeconds;
  inputs.Content = contentOf(this->Subject, inputs, renderer);
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
  if (options.Boundary != BoundaryView::None && !this->Source.shaderOf(SourcePass::BoundaryView))
  {
    return "The view mode shows boundary faces, but an image or a rectilinear grid has none: rays "
           "enter it by the six sides of its box. Choose another one, such as "
           "SetViewModeToCells() or SetViewModeToPicture().";
  }
  if (options.View && options.View->What == Measure::ErrorBound && options.Level.Sampled &&
      this->Blend.isComposite())
  {
    return "The view mode shows error bounds, but the accuracy level is Sampled, and what lies "
           "between samples has none. Choose another level, such as SetAccuracyLevelToDefault(), "
           "or another view mode; CompareWithGroundTruth() measures the errors of samples.";
  }
  return options.View ? describeBadRange(*options.View) : std::string();
}

std::string Pipeline::describeBadSamples(const DrawOptions& options) const
{
  if (options.Level.Sampled && this->Mix != ComponentMix::Single)
  {
    return "The accuracy level is Sampled, which draws one component, but several are drawn "
           "together. Choose one by VectorMode and VectorComponent, or another accuracy level, "
           "such "
           "as SetAccuracyLevelToDefault().";
  }
  return options.Level.Sampled ? this->Source.describeBadSamples() : std::string();
}

bool Pipeline::draw(vtkOpenGLRenderWindow* window, vtkRenderer* renderer,
  const DrawOptions& options, const Progress& progress)
{
  const Viewport area = this->currentViewport();
  if (area.Width <= 0 || area.Height <= 0)
  {
    return true;
  }
  const std::string badView = this->describeBadView(options);
  if (!badView.empty())
  {
    return this->fail(badView);
  }
  const std::string badSamples = this->describeBadSamples(options);
  if (!badSamples.empty())
  {
    return this->fail(badSamples);
  }
  if (options.Stage == ShaderStage::Compute && !this->Compute.Exists)
  {
    return this->fail("The shader stage is Compute, but this GL has no compute shaders: they need "
                      "OpenGL 4.3. Choose SetShaderStageToAutomatic().");
  }
  const MarchInputs inputs = this->inputsOf(options, renderer, area);
  this->Subject.push_back(static_cast<std::uintptr_t>(area.Width));
  this->Subject.push_back(static_cast<std::uintptr_t>(area.Height));

  const FirstColorOnly picture(!options.Peeling); // peels are drawn into several colours on purpose
  // A progress observer may release graphics resources during the frame.
  const auto goOn = [&](double share) { return progress(share) && this->Window == window; };
  bool stopped = false;
  std::string error = describeUnfit(inputs, options.Shared ? SamplersOfVisits : 0);
  std::string shortage = withinMemory("drawing",
    [&] {
      error = error.empty() ? this->EffectsOnGpu.update(window, this->Effects, inputs.Key) : error;
    });
  error = shortage.empty() ? error : shortage;
  shortage = withinMemory("drawing",
    [&]
    {
      if (options.Shared)
      {
        error = this->Passes.drawTogether(window, inputs, this->lightVersion(inputs),
          options.SampleDistance, error, *options.Shared, goOn, stopped);
      }
      else if (error.empty())
      {
        error = this->Passes.draw(window, inputs, this->lightVersion(inputs), options.Diagnostics,
          options.View, options.Boundary, options.SampleDistance, goOn, stopped);
      }
    });
  this->forgetErrorsOfReleasing(window);
  if (!shortage.empty())
  {
    this->Passes.clear();
    error = shortage;
  }
  if (error.empty() && !stopped)
  {
    const bool isWhole = !options.Peeling && !options.Shared && options.SampleDistance <= 1;
    this->Area = isWhole ? inputs.Area : Viewport();
  }
  return error.empty() ? !stopped : this->fail(error);
}

void Pipeline::finish() const { glFinish(); }

} // namespace tetmarch
