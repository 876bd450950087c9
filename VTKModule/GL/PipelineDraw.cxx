// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The last stage of a frame: which variant it needs, and what is drawn; and the same by the CPU.
#include "GL/Pipeline.h"

#include "Caching/WithinMemory.h"
#include "GL/ErrorQueue.h"
#include "GL/FirstColorOnly.h"
#include "Reference/RayTrace.h"

#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <sstream>

namespace tetmarch
{

// The renderer, or the render pass that called, has set it.
Viewport Pipeline::currentViewport() const
{
  std::array<int, 4> area{};
  this->Window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, area.data());
  return { area[0], area[1], area[2], area[3] };
}

VariantKey Pipeline::keyOf(
  const DrawOptions& options, vtkRenderer* renderer, const Viewport& area) const
{
  VariantKey key;
  key.PointScalars = this->CellScalars.empty();
  key.RasterEntry = this->Camera.rastersEntries();
  key.Hierarchy = this->mesh().NeedsHierarchy;
  key.OpaqueDepth = this->Camera.CutsFarPlane || mayHaveOpaqueGeometry(renderer);
  key.HasFma = this->HasFma;
  key.Peeled = options.Peeling != nullptr;
  key.Adaptive = options.Level.Adaptive;
  key.TransparentRanges = this->PassesCells;
  key.ConstantColor = this->Table.Traits.ConstantColor;
  key.Clipped = this->Cut.cuts();
  key.Cropped = this->Cut.Cropped;
  key.NanShown = this->NanShown;
  key.HiddenCells = !this->Hidden.cells().empty();
  this->Blend.setBits(key);
  this->Parts.setBits(key);
  this->Effects.setBits(key, double(area.Width) * area.Height);
  return options.Shell == BoundaryView::None ? key.filtered() : key.ofEntries();
}

// What light at vertices depends on, the mesh first.
Fingerprint Pipeline::lightVersion(const VariantKey& key) const
{
  const LightUniforms& lights = this->Effects.data().Lights;
  Fingerprint version{ static_cast<std::uintptr_t>(this->meshRecord().Runs) };
  version.push_back(static_cast<std::uintptr_t>(this->ScalarsRecord.Runs));
  version.push_back(static_cast<std::uintptr_t>(this->TablesRecord.Runs));
  addAll(version, this->Camera.ThicknessMatrix);
  for (const auto& source : lights.ShadowSources)
  {
    addAll(version, source);
  }
  add(version, lights.Reach);
  add(version, lights.OcclusionRadius);
  version.push_back(static_cast<std::uintptr_t>(lights.OcclusionDirections));
  version.push_back(key.SampledShadows ? 1 : 0); // then it has none of the lights
  version.push_back(key.NanShown ? 1 : 0);
  for (const Fingerprint& effect : { this->Hidden.version(), this->Effects.gradientOpacityVersion(),
         this->Effects.opaqueShadowsVersion() })
  {
    version.insert(version.end(), effect.begin(), effect.end());
  }
  return version;
}

MarchInputs Pipeline::inputsOf(
  const DrawOptions& options, vtkRenderer* renderer, const Viewport& area)
{
  MarchInputs inputs;
  inputs.Area = area;
  inputs.Key = this->keyOf(options, renderer, area);
  inputs.Camera = &this->Camera;
  inputs.Cut = &this->Cut;
  inputs.Mesh = &this->OnGpu.mesh();
  inputs.Tables = &this->OnGpu.tables();
  inputs.Table = &this->Table;
  inputs.Range = this->Range;
  inputs.Parts = &this->Parts;
  inputs.Level = options.Level;
  inputs.Blend = &this->Blend;
  inputs.Effects = &this->EffectsOnGpu;
  inputs.EffectValues = &this->Effects.data();
  inputs.Peeling = options.Peeling;
  inputs.MostSecondsPerDraw = options.MostSecondsPerDraw;
  inputs.MostLightSeconds = options.MostLightSeconds;
  return inputs;
}

// If who was told of progress released what was bound: VTK's records had it bound again.
void Pipeline::forgetErrorsOfReleasing(vtkOpenGLRenderWindow* window)
{
  if (this->Window != window)
  {
    clearErrors();
  }
}

bool Pipeline::draw(vtkOpenGLRenderWindow* window, vtkRenderer* renderer,
  const DrawOptions& options, const Progress& progress)
{
  const Viewport area = this->currentViewport();
  if (area.Width <= 0 || area.Height <= 0)
  {
    return true;
  }
  const std::string badRange = options.View ? describeBadRange(*options.View) : std::string();
  if (!badRange.empty())
  {
    return this->fail(badRange);
  }
  this->Subject.push_back(static_cast<std::uintptr_t>(area.Width));
  this->Subject.push_back(static_cast<std::uintptr_t>(area.Height));
  const MarchInputs inputs = this->inputsOf(options, renderer, area);

  const FirstColorOnly picture(!options.Peeling); // peels go into several on purpose
  // Who is told of progress may release what is being drawn.
  const auto goOn = [&](double share) { return progress(share) && this->Window == window; };
  bool stopped = false;
  std::string error;
  const std::string shortage = withinMemory("drawing",
    [&]
    {
      error = this->EffectsOnGpu.update(window, this->Effects, inputs.Key);
      if (error.empty())
      {
        error = this->Passes.draw(window, this->mesh(), inputs, this->lightVersion(inputs.Key),
          options.Diagnostics, options.View, options.Shell, options.SampleDistance, goOn, stopped);
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
    this->Area = options.Peeling || options.SampleDistance > 1 ? Viewport() : inputs.Area;
  }
  return error.empty() ? !stopped : this->fail(error);
}

bool Pipeline::useReferenceScene(vtkVolumeProperty* property, OpacityLaw law,
  const AccuracyLevel& level, const std::function<void(ReferenceScene&)>& use)
{
  if (!this->Window || this->Area.Width <= 0 || this->Area.Height <= 0)
  {
    return this->fail("There is no frame to compare with: render the window first, with a ray "
                      "a pixel and without peels of translucent geometry.");
  }
  if (!this->ensureHierarchy())
  {
    return false;
  }
  const std::string shortage = withinMemory("the reference picture",
    [&]
    {
      const std::vector<float> depths = this->Passes.opaqueDepths(this->Window);
      Components parts = this->Parts;
      const IntegralTable table = this->makeTables(property, law, level, parts);
      ReferenceScene scene;
      scene.Mesh = &this->mesh();
      scene.CellScalars = this->CellScalars.empty() ? nullptr : &this->CellScalars;
      scene.Range = this->Range;
      scene.NanShown = this->NanShown;
      scene.Hidden = &this->Hidden.cells();
      scene.Table = &table;
      scene.Camera = this->Camera;
      scene.Width = this->Area.Width;
      scene.Height = this->Area.Height;
      scene.WindowDepths = depths.empty() ? nullptr : depths.data();
      scene.Cut = this->Cut;
      scene.Effects = &this->Effects.data();
      scene.Blend = &this->Blend;
      scene.Parts = &parts;
      use(scene);
    });
  return shortage.empty() || this->fail(shortage);
}

bool Pipeline::renderReference(vtkVolumeProperty* property, OpacityLaw law, ReferenceImage& image)
{
  return this->useReferenceScene(property, law, GroundTruthAccuracy,
    [&](ReferenceScene& scene)
    { image = tetmarch::renderReference<double>(scene, GroundTruthAccuracy); });
}

bool Pipeline::traceRay(
  vtkVolumeProperty* property, OpacityLaw law, const TraceOptions& options, RayTrace& trace)
{
  const Viewport& area = this->Area;
  const int x = options.X - area.X;
  const int y = options.Y - area.Y;
  const bool drawn = area.Width > 0 && area.Height > 0;
  if (drawn && (x < 0 || y < 0 || x >= area.Width || y >= area.Height))
  {
    std::ostringstream error;
    error << "The pixel (" << options.X << ", " << options.Y << ") is outside the last frame, of "
          << area.Width << " x " << area.Height << " pixels from (" << area.X << ", " << area.Y
          << ") on.";
    return this->fail(error.str());
  }
  return this->useReferenceScene(property, law, options.Level,
    [&](ReferenceScene& scene)
    {
      scene.ExactLight = options.ExactLight || this->Passes.samplesShadows();
      trace = options.InDouble ? tetmarch::traceRay<double>(scene, options.Level, x, y)
                               : tetmarch::traceRay<float>(scene, options.Level, x, y);
    });
}

} // namespace tetmarch
