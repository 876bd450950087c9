// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/Pipeline.h"

#include "GL/FmaProbe.h"
#include "Scene/WithinMemory.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

namespace tetmarch
{

bool Pipeline::fail(const std::string& error)
{
  this->Error = error;
  return false;
}

void Pipeline::begin(std::uint64_t mostBytes)
{
  this->Error.clear();
  this->Passes.clear();
  this->Area = {};
  this->RunsBefore = this->stageRuns();
  this->Subject.clear();
  this->Limits = { mostTexels(), mostBytes };
}

std::int64_t Pipeline::stageRuns() const
{
  return this->meshRecord().Runs + this->ScalarsRecord.Runs + this->TablesRecord.Runs +
         this->UploadRecord.Runs;
}

bool Pipeline::onlyDrew() const
{
  return this->stageRuns() == this->RunsBefore && !this->Passes.changedVariant();
}

bool Pipeline::updateMesh(vtkUnstructuredGrid* grid, const Progress& progress)
{
  std::string error;
  if (!this->Meshed.isCurrent(grid))
  {
    this->ScalarsInput.clear();
    this->OnGpu.expectMesh();
    error = this->Meshed.make(grid, this->Limits, progress);
  }
  return error.empty() ? !this->mesh().Tets.empty() : this->fail(error);
}

bool Pipeline::updateScalars(vtkUnstructuredGrid* grid, vtkDataArray* array, bool cellScalars)
{
  const std::string wrong = cellScalars ? checkScalars(array, grid->GetNumberOfCells(), "cells")
                                        : checkScalars(array, grid->GetNumberOfPoints(), "points");
  if (!wrong.empty())
  {
    return this->fail(wrong);
  }
  Fingerprint input;
  add(input, array);
  input.push_back(cellScalars ? 1 : 0);
  if (input == this->ScalarsInput)
  {
    return true;
  }
  StageRecorder recorder(this->ScalarsRecord);
  this->ScalarsInput.clear();
  this->OnGpu.expectScalars();
  this->CellScalars.clear();
  const std::string shortage = withinMemory("the scalars",
    [&]
    {
      this->Range = cellScalars ? makeCellScalars(array, this->mesh(), this->CellScalars)
                                : setPointScalars(grid, array, this->Meshed.mesh());
    });
  if (!shortage.empty())
  {
    return this->fail(shortage);
  }
  this->ScalarsInput = input;
  return true;
}

bool Pipeline::updateTables(vtkVolumeProperty* property, OpacityLaw law, const AccuracyLevel& level)
{
  Fingerprint input;
  add(input, property->GetScalarOpacity());
  add(input, property->GetColorChannels() == 1
               ? static_cast<vtkObject*>(property->GetGrayTransferFunction())
               : property->GetRGBTransferFunction());
  input.push_back(static_cast<std::uintptr_t>(law));
  add(input, this->Range.Low);
  add(input, this->Range.High);
  this->Subject = input;
  this->Subject.push_back(static_cast<std::uintptr_t>(this->meshRecord().Runs));
  this->Subject.push_back(static_cast<std::uintptr_t>(this->ScalarsRecord.Runs));
  add(this->Subject, property->GetScalarOpacityUnitDistance());
  input.push_back(static_cast<std::uintptr_t>(level.LeastTableEntries));
  input.push_back(static_cast<std::uintptr_t>(level.MostTableEntries));
  add(input, level.ErrorTolerance);
  if (input != this->TablesInput)
  {
    StageRecorder recorder(this->TablesRecord);
    this->TablesInput.clear();
    this->OnGpu.expectTables();
    const std::string shortage = withinMemory("the tables of the transfer functions",
      [&] { this->Table = fittingTable(property, law, this->Range.Low, this->Range.High, level); });
    if (!shortage.empty())
    {
      return this->fail(shortage);
    }
    this->Visible = std::any_of(this->Table.Values.begin(), this->Table.Values.end(),
      [](const std::array<float, 4>& v) { return v[3] > 0; });
    this->TablesInput = input;
  }
  return this->Visible;
}

bool Pipeline::updateEffects(vtkRenderer* renderer, vtkVolume* volume, const EffectOptions& options)
{
  EffectInput input{ &this->mesh(), &this->CellScalars, &this->Range, {} };
  input.Which.push_back(static_cast<std::uintptr_t>(this->meshRecord().Runs));
  input.Which.push_back(static_cast<std::uintptr_t>(this->ScalarsRecord.Runs));
  const std::string error = this->Effects.update(renderer, volume, options, input);
  return error.empty() || this->fail(error);
}

bool Pipeline::updateView(vtkRenderer* renderer, vtkVolume* volume)
{
  const double unit = volume->GetProperty()->GetScalarOpacityUnitDistance();
  if (!(unit > 0))
  {
    return this->fail("The scalar opacity unit distance is " + std::to_string(unit) +
                      "; it must be above 0 (vtkVolumeProperty::SetScalarOpacityUnitDistance).");
  }
  if (!makeView(renderer, volume, this->mesh(), unit, this->Camera))
  {
    return this->fail("The matrix of the volume or of the camera is singular or not finite.");
  }
  return this->Camera.rastersEntries() || this->ensureHierarchy();
}

bool Pipeline::ensureHierarchy()
{
  if (!this->mesh().hasHierarchy())
  {
    const std::string error = this->Meshed.addHierarchy();
    if (!error.empty())
    {
      return this->fail(error);
    }
    this->OnGpu.expectLinks();
  }
  return true;
}

bool Pipeline::upload(vtkOpenGLRenderWindow* window)
{
  if (this->Window != window)
  {
    if (this->Window)
    {
      this->Window->MakeCurrent();
      this->release(this->Window);
      window->MakeCurrent();
    }
    this->Window = window;
    this->Watch.begin(window, [this](vtkWindow* ending) { this->release(ending); });
    this->HasFma = hasFusedMultiplyAdd(window);
  }
  const std::string excess =
    describeExcess(bufferSizes(this->mesh(), this->CellScalars.size(), this->Table.Values.size()),
      this->Limits, SizesAre::Exact);
  if (!excess.empty())
  {
    this->release(window);
    return this->fail(excess);
  }
  if (this->OnGpu.isCurrent())
  {
    return true;
  }
  StageRecorder recorder(this->UploadRecord);
  const std::string error =
    this->OnGpu.upload(window, this->mesh(), this->CellScalars, this->Table);
  this->Passes.expectChange();
  if (!error.empty())
  {
    this->release(window);
    return this->fail(error);
  }
  return true;
}

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
  key.Adaptive = options.Level.Adaptive;
  this->Effects.setBits(key, double(area.Width) * area.Height);
  return options.Shell == ShellView::None ? key.filtered() : key.ofEntries();
}

// What light at vertices depends on.
Fingerprint Pipeline::lightVersion(const VariantKey& key) const
{
  const LightUniforms& lights = this->Effects.data().Lights;
  Fingerprint version = this->Effects.gradientOpacityVersion();
  version.push_back(static_cast<std::uintptr_t>(this->meshRecord().Runs));
  version.push_back(static_cast<std::uintptr_t>(this->ScalarsRecord.Runs));
  version.push_back(static_cast<std::uintptr_t>(this->TablesRecord.Runs));
  for (double x : this->Camera.LengthMatrix)
  {
    add(version, x);
  }
  for (const auto& source : lights.ShadowSources)
  {
    for (double x : source)
    {
      add(version, x);
    }
  }
  add(version, lights.Reach);
  add(version, lights.OcclusionRadius);
  version.push_back(static_cast<std::uintptr_t>(lights.OcclusionDirections));
  version.push_back(key.SampledShadows ? 1 : 0); // then it has none of the lights
  return version;
}

bool Pipeline::draw(vtkOpenGLRenderWindow* window, vtkRenderer* renderer,
  const DrawOptions& options, const Progress& progress)
{
  MarchInputs inputs;
  inputs.Area = this->currentViewport();
  if (inputs.Area.Width <= 0 || inputs.Area.Height <= 0)
  {
    return true;
  }
  const std::string badRange = options.View ? describeBadRange(*options.View) : std::string();
  if (!badRange.empty())
  {
    return this->fail(badRange);
  }
  this->Subject.push_back(static_cast<std::uintptr_t>(inputs.Area.Width));
  this->Subject.push_back(static_cast<std::uintptr_t>(inputs.Area.Height));
  inputs.Key = this->keyOf(options, renderer, inputs.Area);
  inputs.Camera = &this->Camera;
  inputs.Mesh = &this->OnGpu.mesh();
  inputs.Tables = &this->OnGpu.tables();
  inputs.Table = &this->Table;
  inputs.Range = this->Range;
  inputs.Level = options.Level;
  inputs.Effects = &this->EffectsOnGpu;
  inputs.EffectValues = &this->Effects.data();
  inputs.MostSecondsPerDraw = options.MostSecondsPerDraw;

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
          options.Diagnostics, options.View, options.Shell, goOn, stopped);
      }
    });
  if (!shortage.empty())
  {
    this->Passes.clear();
    error = shortage;
  }
  if (error.empty() && !stopped)
  {
    this->Area = inputs.Area;
  }
  return error.empty() ? !stopped : this->fail(error);
}

bool Pipeline::renderReference(vtkVolumeProperty* property, OpacityLaw law, ReferenceImage& image)
{
  if (!this->Window || this->Area.Width <= 0 || this->Area.Height <= 0)
  {
    return this->fail("There is no frame to compare with: render the window first.");
  }
  if (!this->ensureHierarchy())
  {
    return false;
  }
  const std::string shortage = withinMemory("the reference picture",
    [&]
    {
      const std::vector<float> depths = this->Passes.opaqueDepths(this->Window);
      const IntegralTable table =
        fittingTable(property, law, this->Range.Low, this->Range.High, YardstickAccuracy);
      ReferenceScene scene;
      scene.Mesh = &this->mesh();
      scene.CellScalars = this->CellScalars.empty() ? nullptr : &this->CellScalars;
      scene.Range = this->Range;
      scene.Table = &table;
      scene.Camera = this->Camera;
      scene.Width = this->Area.Width;
      scene.Height = this->Area.Height;
      scene.WindowDepths = depths.empty() ? nullptr : depths.data();
      scene.Effects = &this->Effects.data();
      image = tetmarch::renderReference<double>(scene, YardstickAccuracy);
    });
  return shortage.empty() || this->fail(shortage);
}

void Pipeline::release(vtkWindow* window)
{
  this->Watch.end(window);
  this->OnGpu.release(window);
  this->EffectsOnGpu.release(window);
  this->Passes.release(window);
  this->Window = nullptr;
}

} // namespace tetmarch
