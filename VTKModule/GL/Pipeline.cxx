// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/Pipeline.h"

#include "Caching/WithinMemory.h"
#include "GL/BlockAttributes.h"
#include "GL/Driver.h"
#include "GL/ErrorQueue.h"
#include "GL/StateScope.h"

#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

namespace tetmarch
{

bool Pipeline::fail(const std::string& error)
{
  this->Error = error;
  return false;
}

void Pipeline::begin(std::uint64_t mostBytes)
{
  this->beginPick(mostBytes);
  this->Passes.clear();
  this->Found.clear();
  this->RunsBefore = this->stageRuns();
  this->Subject.clear();
}

void Pipeline::beginPick(std::uint64_t mostBytes)
{
  this->Error.clear();
  this->Area = {};
  this->Limits = { mostTexels(), mostBytes };
}

std::int64_t Pipeline::stageRuns() const
{
  return this->Source.runs() + this->Tables.record().Runs + this->UploadRecord.Runs +
         this->Effects.gradientsRecord().Runs + this->Effects.gradientOpacityRecord().Runs +
         this->Effects.startsRecord().Runs + this->Effects.opaqueShadowsRecord().Runs +
         this->vertexLightRecord().Runs;
}

bool Pipeline::onlyDrew() const
{
  return this->stageRuns() == this->RunsBefore && !this->Passes.changedVariant() &&
         this->isLightComplete();
}

bool Pipeline::updateGeometry(vtkDataSet* data, const Progress& progress)
{
  // The GL is looked at once: before anything is held in it.
  std::string error = this->Window ? std::string() : describeMissing();
  error = error.empty() ? this->Source.updateGeometry(data, this->Limits, progress) : error;
  return error.empty() ? !this->Source.isEmpty() : this->fail(error);
}

bool Pipeline::chooseScalars(vtkDataSet* data, vtkDataArray* array, bool ofCells,
  const VectorOptions& options, vtkVolumeProperty* property, DrawnScalars& drawn)
{
  const std::string error = tetmarch::chooseScalars(data, array, ofCells, options, property, drawn);
  return error.empty() || this->fail(error);
}

std::vector<FiniteRange> Pipeline::findRanges(vtkDataSet* data, const DrawnScalars& drawn)
{
  return this->Source.rangesOf(data, drawn);
}

bool Pipeline::updateScalars(vtkDataSet* data, const DrawnScalars& drawn)
{
  this->Mix = drawn.Mix;
  const std::string error = this->Source.updateScalars(data, drawn);
  return error.empty() || this->fail(error);
}

bool Pipeline::updateBlending(vtkVolumeProperty* property, const BlendOptions& options)
{
  std::string error = makeBlending(options, property, this->Source.range(), this->Blend);
  if (error.empty() && this->Mix != ComponentMix::Single && !this->Blend.isComposite())
  {
    error = "Several components are drawn together by composite blending alone, but the blend mode "
            "is another. Choose one of them by VectorMode.";
  }
  return error.empty() || this->fail(error);
}

// Where the scalar bends, a segment crosses narrow peaks by more subsegments until the tolerance is
// kept: of volumes with peaks of a hundredth of the range, up to 200 in a cell at 1/255.
AccuracyLevel Pipeline::levelFor(AccuracyLevel level) const
{
  constexpr int Bent = 8;
  level.MostTrials *= level.Adaptive && this->Source.scalarBends() ? Bent : 1;
  return level;
}

TableInput Pipeline::tableInput(OpacityLaw law) const
{
  return { law, &this->Blend, this->Mix, this->Source.range(), this->Source.furtherRanges(),
    this->Source.scalarBends(), this->Limits.TexelsPerBuffer };
}

bool Pipeline::updateTables(
  vtkVolumeProperty* property, OpacityLaw law, const AccuracyLevel& level, bool drawNan)
{
  const std::string error = this->Tables.update(property, this->tableInput(law), level);
  if (!error.empty())
  {
    return this->fail(error);
  }
  this->NanShown =
    drawNan && !this->Source.range().AllFinite && this->Tables.first().NanColor[3] > 0;
  if (!this->updatePassing())
  {
    return false;
  }
  this->setSubject(property, drawNan);
  // Sums are shown even where they are 0.
  return this->Tables.isVisible() || this->NanShown || this->Blend.isSum();
}

void Pipeline::setSubject(vtkVolumeProperty* property, bool drawNan)
{
  this->Subject = this->Tables.shown();
  add(this->Subject, this->Source.version());
  add(this->Subject, property->GetScalarOpacityUnitDistance());
  this->Subject.push_back(drawNan ? 1 : 0);
  add(this->Subject, versionOf(this->Blend));
}

bool Pipeline::updatePassing()
{
  Fingerprint input = this->Source.version();
  input.push_back(static_cast<std::uintptr_t>(this->Tables.record().Runs));
  input.push_back(this->NanShown ? 1 : 0);
  add(input, versionOf(this->Blend));
  if (input == this->PassingInput)
  {
    return true;
  }
  this->PassingInput.clear();
  const std::string error = this->Source.updateVisibility(
    this->Tables.first(), this->Tables.components(), this->Blend, this->NanShown);
  if (!error.empty())
  {
    return this->fail(error);
  }
  const double share = this->Source.transparentShare(this->Tables.first());
  this->PassesCells.update(
    share >= LeastShareToPass, share >= LeastShareToKeepPassing, this->Source.version());
  this->PassingInput = input;
  return true;
}

bool Pipeline::updateEffects(vtkRenderer* renderer, vtkVolume* volume, const EffectOptions& options)
{
  std::string error = this->Effects.update(
    renderer, volume, options, { &this->Source.effectSource(), blockAttributes });
  const bool lit = options.Shown != Subject::Picture || !this->Effects.data().empty();
  if (error.empty() && lit && this->Mix == ComponentMix::Independent)
  {
    this->Effects.clear();
    error = "Several independent components are drawn together without light and gradients, but "
            "shading (vtkVolumeProperty::ShadeOn()), gradient opacity or a view of them is on. "
            "Switch that off, or choose one component by VectorMode.";
  }
  return error.empty() || this->fail(error);
}

bool Pipeline::updateView(vtkRenderer* renderer, vtkVolume* volume, OpacityLaw law)
{
  const double unit = volume->GetProperty()->GetScalarOpacityUnitDistance();
  if (!(unit > 0))
  {
    return this->fail("The scalar opacity unit distance is " + std::to_string(unit) +
                      "; it must be above 0 (vtkVolumeProperty::SetScalarOpacityUnitDistance).");
  }
  if (!makeView(renderer, volume, this->Source.frame(), unit, law, this->Camera))
  {
    return this->fail("The matrix of the volume or of the camera is singular or not finite.");
  }
  const std::string error = this->Camera.CutsNearPlane ? this->prepareEntrySearch() : std::string();
  return error.empty() || this->fail(error);
}

std::string Pipeline::prepareEntrySearch()
{
  const std::string error = this->Source.prepareEntrySearch();
  const std::string shortage = withinMemory("the starts of rays towards the light",
    [&] { this->Effects.refreshStarts(this->Source.effectSource()); });
  return error.empty() ? shortage : error;
}

bool Pipeline::updateClipping(vtkVolume* volume, const ClippingOptions& options)
{
  const std::string error = makeClipping(options, volume, this->Source.frame(), this->Cut);
  return error.empty() ? !this->Cut.LeavesNothing : this->fail(error);
}

// What another window's GPU holds is freed there.
void Pipeline::moveTo(vtkOpenGLRenderWindow* window)
{
  forgetLostBuffers(window);
  if (this->Window == window)
  {
    return;
  }
  if (this->Window)
  {
    this->releaseWhereHeld();
    window->MakeCurrent();
  }
  this->Window = window;
  this->Watch.begin(window, [this](vtkWindow* ending) { this->release(ending); });
  this->PredicateIsKnown = false;
  this->Compute = computeSupport();
}

std::vector<BufferSize> Pipeline::bufferSizes() const
{
  std::vector<BufferSize> sizes = this->Source.bufferSizes();
  const std::vector<BufferSize> tables = this->Tables.bufferSizes();
  sizes.insert(sizes.end(), tables.begin(), tables.end());
  return sizes;
}

bool Pipeline::upload(vtkOpenGLRenderWindow* window)
{
  this->moveTo(window);
  std::string error = describeExcess(this->bufferSizes(), this->Limits, SizesAre::Exact);
  error = error.empty() ? this->findPredicate(window) : error;
  const bool current = this->Source.isUploaded() && this->TablesOnGpu.holds(this->Tables);
  if (error.empty() && !current)
  {
    const StageRecorder recorder(this->UploadRecord);
    const std::string shortage = withinMemory("what goes to the GPU",
      [&]
      {
        error = this->Source.upload(window);
        error = error.empty() ? this->TablesOnGpu.upload(window, this->Tables) : error;
      });
    error = shortage.empty() ? error : shortage;
  }
  if (!error.empty())
  {
    this->release(window);
    clearErrors(); // VTK detaches shaders of programs that could not be linked twice
    return this->fail(error);
  }
  return true;
}

std::size_t Pipeline::gpuBytes() const
{
  return this->Source.bytes() + this->TablesOnGpu.bytes() + this->EffectsOnGpu.bytes() +
         this->Passes.bytes();
}

void Pipeline::release(vtkWindow* window)
{
  this->Watch.end(window);
  this->Source.release(window);
  this->TablesOnGpu.release(window);
  this->EffectsOnGpu.release(window);
  this->Passes.release(window);
  this->Selected.release();
  this->Window = nullptr;
}

void Pipeline::releaseWhereHeld()
{
  if (this->Window)
  {
    this->makeCurrent();
    this->release(this->Window);
  }
}

void Pipeline::releaseIfHeldBy(vtkWindow* window)
{
  if (this->Window == window)
  {
    this->releaseWhereHeld();
  }
}

void Pipeline::makeCurrent() const
{
  if (this->Window)
  {
    this->Window->MakeCurrent();
  }
}

} // namespace tetmarch
