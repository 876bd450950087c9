// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/Pipeline.h"

#include "GL/Driver.h"
#include "GL/ErrorQueue.h"
#include "GL/StateScope.h"

#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"

namespace tetmarch
{

void Pipeline::begin(std::uint64_t mostBytes)
{
  this->beginPick(mostBytes);
  this->Passes.clear();
  this->Found.clear();
  this->RunsBefore = this->stageRuns();
  this->Content.clear();
}

void Pipeline::beginPick(std::uint64_t mostBytes)
{
  this->Area = {};
  this->Limits = { mostTexels(), mostBytes };
  this->Stages.setLimits(this->Limits);
}

std::int64_t Pipeline::stageRuns() const
{
  return this->Stages.runs() + this->UploadRecord.Runs + this->vertexLightRecord().Runs;
}

bool Pipeline::onlyDrew() const
{
  return this->stageRuns() == this->RunsBefore && !this->Passes.changedVariant() &&
         this->isLightComplete();
}

StageResult Pipeline::update(
  vtkOpenGLRenderWindow* window, const FrameInput& input, const Progress& progress)
{
  return guarded(
    [&]
    {
      DrawnScalars drawn;
      return this->updateGeometry(input, progress)
        .then([&] { return FrameStages::chooseScalars(input, drawn); })
        .then([&] { return this->Stages.updateScalars(input, drawn); })
        .then([&] { return this->updateRays(window, input); });
    });
}

StageResult Pipeline::updateGeometry(const FrameInput& input, const Progress& progress)
{
  // The GL is looked at once: before anything is held in it.
  const std::string missing = this->Window ? std::string() : describeMissing();
  return missing.empty() ? this->Stages.updateGeometry(input, progress) : StageResult{ missing };
}

StageResult Pipeline::updateRays(vtkOpenGLRenderWindow* window, const FrameInput& input)
{
  return this->Stages.updateRays(input).then([&] { return StageResult{ this->upload(window) }; });
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
  std::vector<BufferSize> sizes = this->Textures.bufferSizes();
  const std::vector<BufferSize> tables = this->Stages.tables().bufferSizes();
  sizes.insert(sizes.end(), tables.begin(), tables.end());
  return sizes;
}

std::string Pipeline::upload(vtkOpenGLRenderWindow* window)
{
  this->moveTo(window);
  std::string error = describeExcess(this->bufferSizes(), this->Limits, SizesAre::Exact);
  error = error.empty() ? this->findPredicate(window) : error;
  const bool current = this->Textures.isCurrent() && this->TablesOnGpu.holds(this->Stages.tables());
  if (error.empty() && !current)
  {
    const StageRecorder recorder(this->UploadRecord);
    const std::string shortage = withinMemory("what goes to the GPU",
      [&]
      {
        error = this->Textures.upload(window);
        error = error.empty() ? this->TablesOnGpu.upload(window, this->Stages.tables()) : error;
      });
    error = shortage.empty() ? error : shortage;
  }
  if (!error.empty())
  {
    this->release(window);
    clearErrors(); // VTK detaches shaders of programs that could not be linked twice
  }
  return error;
}

std::size_t Pipeline::gpuBytes() const
{
  return this->Textures.bytes() + this->TablesOnGpu.bytes() + this->EffectsOnGpu.bytes() +
         this->Passes.bytes();
}

void Pipeline::release(vtkWindow* window)
{
  this->Watch.end(window);
  this->Textures.release(window);
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
