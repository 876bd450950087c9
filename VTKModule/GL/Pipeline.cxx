// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/Pipeline.h"

#include "Appearance/TransparentShare.h"
#include "Caching/WithinMemory.h"
#include "GL/BlockAttributes.h"
#include "GL/FmaProbe.h"
#include "GL/StateScope.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
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

void Pipeline::beginPick(std::uint64_t mostBytes)
{
  this->Error.clear();
  this->Area = {};
  this->Limits = { mostTexels(), mostBytes };
}

std::int64_t Pipeline::stageRuns() const
{
  return this->meshRecord().Runs + this->Hidden.record().Runs + this->ScalarsRecord.Runs +
         this->TablesRecord.Runs + this->UploadRecord.Runs + this->Effects.gradientsRecord().Runs +
         this->Effects.gradientOpacityRecord().Runs + this->Effects.startsRecord().Runs +
         this->Effects.opaqueShadowsRecord().Runs + this->vertexLightRecord().Runs;
}

bool Pipeline::onlyDrew() const
{
  return this->stageRuns() == this->RunsBefore && !this->Passes.changedVariant() &&
         this->isLightComplete();
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

bool Pipeline::updateHiddenCells(vtkUnstructuredGrid* grid)
{
  const std::string shortage = withinMemory("the hidden cells",
    [&]
    {
      if (this->Hidden.update(grid, this->mesh(), this->meshRecord().Runs))
      {
        this->OnGpu.expectHiddenCells();
      }
    });
  return shortage.empty() || this->fail(shortage);
}

bool Pipeline::updateScalars(vtkUnstructuredGrid* grid, vtkDataArray* array, bool cellScalars,
  const VectorOptions& vector, vtkVolumeProperty* property)
{
  std::string wrong = cellScalars ? checkScalars(array, grid->GetNumberOfCells(), "cells")
                                  : checkScalars(array, grid->GetNumberOfPoints(), "points");
  DrawnComponents drawn;
  if (wrong.empty())
  {
    drawn = drawnComponents(vector, property, array, wrong);
  }
  if (!wrong.empty())
  {
    return this->fail(wrong);
  }
  Fingerprint input;
  add(input, array);
  input.push_back(cellScalars ? 1 : 0);
  input.push_back(static_cast<std::uintptr_t>(drawn.Mix));
  input.push_back(drawn.Scalar.Magnitude ? 1 : 0);
  input.push_back(static_cast<std::uintptr_t>(drawn.Scalar.Component));
  if (input == this->ScalarsInput)
  {
    return true;
  }
  StageRecorder recorder(this->ScalarsRecord);
  this->ScalarsInput.clear();
  this->OnGpu.expectScalars();
  const std::string shortage = withinMemory("the scalars",
    [&]
    {
      this->Range = readComponents(
        grid, array, cellScalars, drawn, this->Meshed.mesh(), this->CellScalars, this->Parts);
    });
  if (!shortage.empty())
  {
    return this->fail(shortage);
  }
  this->ScalarsInput = input;
  return true;
}

bool Pipeline::updateBlending(vtkVolumeProperty* property, const BlendOptions& options)
{
  std::string error = makeBlending(options, property, this->Range, this->Blend);
  if (error.empty() && !this->Parts.isSingle() && !this->Blend.isComposite())
  {
    error = "Several components are drawn together by composite blending alone, but the blend mode "
            "is another. Choose one of them by VectorMode.";
  }
  return error.empty() || this->fail(error);
}

bool Pipeline::updateTables(
  vtkVolumeProperty* property, OpacityLaw law, const AccuracyLevel& level, bool drawNan)
{
  Fingerprint input;
  add(input, property->GetScalarOpacity());
  add(input, property->GetColorChannels() == 1
               ? static_cast<vtkObject*>(property->GetGrayTransferFunction())
               : property->GetRGBTransferFunction());
  input.push_back(
    static_cast<std::uintptr_t>(this->Blend.isComposite() ? law : OpacityLaw::Unstructured));
  input.push_back(this->Blend.isSum() ? 1 : 0);
  add(input, this->Range.Low);
  add(input, this->Range.High);
  addFunctions(input, this->Parts, property);
  const std::string badUnit = setFactors(property, this->Parts);
  if (!badUnit.empty())
  {
    return this->fail(badUnit);
  }
  this->Subject = input;
  addAll(this->Subject, this->Parts.Factors);
  this->Subject.push_back(static_cast<std::uintptr_t>(this->meshRecord().Runs));
  this->Subject.push_back(static_cast<std::uintptr_t>(this->ScalarsRecord.Runs));
  add(this->Subject, property->GetScalarOpacityUnitDistance());
  this->Subject.push_back(drawNan ? 1 : 0);
  this->Subject.insert(
    this->Subject.end(), this->Hidden.version().begin(), this->Hidden.version().end());
  const Fingerprint blend = versionOf(this->Blend);
  this->Subject.insert(this->Subject.end(), blend.begin(), blend.end());
  input.push_back(static_cast<std::uintptr_t>(level.LeastTableEntries));
  input.push_back(static_cast<std::uintptr_t>(level.MostTableEntries));
  add(input, level.ErrorTolerance);
  if (input != this->TablesInput)
  {
    StageRecorder recorder(this->TablesRecord);
    this->TablesInput.clear();
    this->OnGpu.expectTables();
    const std::string shortage = withinMemory("the tables of the transfer functions",
      [&] { this->Table = this->makeTables(property, law, level, this->Parts); });
    if (!shortage.empty())
    {
      return this->fail(shortage);
    }
    this->Visible = hasExtinction(this->Table) || this->Parts.isFurtherVisible();
    this->TablesInput = input;
  }
  this->NanShown = drawNan && !this->Range.AllFinite && this->Table.NanColor[3] > 0;
  const Fingerprint passes{ static_cast<std::uintptr_t>(this->ScalarsRecord.Runs),
    static_cast<std::uintptr_t>(this->TablesRecord.Runs) };
  if (passes != this->PassesInput)
  {
    this->PassesInput = passes;
    this->PassesCells = transparentShare(this->mesh(), this->CellScalars, this->Range,
                          this->Table) >= LeastShareToPass;
  }
  // Sums are shown even where they are 0.
  return this->Visible || this->NanShown || this->Blend.isSum();
}

IntegralTable Pipeline::makeTables(
  vtkVolumeProperty* property, OpacityLaw law, const AccuracyLevel& level, Components& parts) const
{
  return parts.isSingle() ? blendedTable(property, law, this->Blend, this->Range, level)
                          : componentTables(property, law, this->Range, level, parts);
}

bool Pipeline::updateEffects(vtkRenderer* renderer, vtkVolume* volume, const EffectOptions& options)
{
  EffectInput input{ &this->mesh(), &this->CellScalars, &this->Range, {}, blockAttributes };
  input.Which.push_back(static_cast<std::uintptr_t>(this->meshRecord().Runs));
  input.Which.push_back(static_cast<std::uintptr_t>(this->ScalarsRecord.Runs));
  std::string error = this->Effects.update(renderer, volume, options, input);
  const bool lit = options.Shown != Subject::Picture || !this->Effects.data().empty();
  if (error.empty() && lit && this->Parts.isIndependent())
  {
    this->Effects.clear();
    error = "Several independent components are drawn together without light and gradients, but "
            "shading (vtkVolumeProperty::ShadeOn()), gradient opacity or a view of them is on. "
            "Switch that off, or choose one component by VectorMode.";
  }
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

bool Pipeline::updateClipping(vtkVolume* volume, const ClippingOptions& options)
{
  const std::string error = makeClipping(options, volume, this->mesh(), this->Cut);
  return error.empty() ? !this->Cut.LeavesNothing : this->fail(error);
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
  forgetLostBuffers(window);
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
  std::vector<BufferSize> sizes = bufferSizes(
    this->mesh(), this->CellScalars.size(), this->Hidden.cells().size(), this->Table.Values.size());
  addBufferSizes(sizes, this->Parts, this->Table);
  const std::string excess = describeExcess(sizes, this->Limits, SizesAre::Exact);
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
  const std::string error = this->OnGpu.upload(
    window, this->mesh(), this->CellScalars, this->Hidden.cells(), this->Table, this->Parts);
  this->Passes.expectChange();
  if (!error.empty())
  {
    this->release(window);
    return this->fail(error);
  }
  return true;
}

void Pipeline::release(vtkWindow* window)
{
  this->Watch.end(window);
  this->OnGpu.release(window);
  this->EffectsOnGpu.release(window);
  this->Passes.release(window);
  this->Selected.release();
  this->Window = nullptr;
}

} // namespace tetmarch
