// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mapper/MapperFrame.h"

#include "Frame/NothingVisible.h"
#include "GL/BlockAttributes.h"
#include "Mapper/CaptureScope.h"
#include "Mapper/FrameMeasures.h"
#include "Mapper/MapperState.h"

#include "vtkDataArray.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"

#include <algorithm>

namespace tetmarch
{

MapperFrame::MapperFrame(const MapperScene& scene, MapperState& state, const BlendOptions& blend,
  const FrameConditions& conditions)
  : Scene(scene)
  , State(state)
  , Report(
      [scene](double share)
      {
        scene.Mapper->UpdateProgress(share);
        return !scene.Renderer->GetRenderWindow()->CheckAbortStatus();
      })
  , Hooks(scene.Volume, scene.Mapper)
  , Options(state.Settings.get(), static_cast<BlendMode>(blend.Mode), scene.Renderer, state.Chosen,
      this->Hooks, conditions, state.ViewTable)
{
  this->Timer->StartTimer();
  // At rest the time that VTK allocates is finite, too, but nobody waits for it.
  const double seconds =
    isInteractive(scene.Renderer->GetRenderWindow()) ? scene.Volume->GetAllocatedRenderTime() : 0.0;
  this->Options.chooseSampleDistance(
    state.Settings.get(), conditions.AdjustsDistances, state.Distance, seconds);
}

MapperFrame::~MapperFrame() = default;

FrameInput MapperFrame::inputOf(const DrawnData& drawn) const
{
  return { drawn, this->Scene.Renderer, this->Scene.Volume, this->Options.Law, this->State.Level,
    this->Options.DrawNanCells, this->Options.Effects, blockAttributes };
}

StageResult MapperFrame::prepare(Pipeline& pipeline, const DrawnData& drawn)
{
  const StageResult result =
    pipeline.update(this->Scene.Window, this->inputOf(drawn), this->Report);
  const char* name = drawn.Scalars.Array ? drawn.Scalars.Array->GetName() : nullptr;
  this->ArrayName = name ? name : "";
  this->noteVisibility(
    result.Error.empty() ? whyNothingIsVisible(pipeline.stages()) : std::string());
  return result;
}

StageResult MapperFrame::draw(Pipeline& pipeline, const CellOrigins& origins)
{
  vtkRenderer* renderer = this->Scene.Renderer;
  this->Pipelines.push_back(&pipeline);
  const StageResult result = guarded(
    [&]
    {
      // With several processes, the others wait for this one to draw.
      CaptureScope* capture =
        this->Options.Draw.Shared ? nullptr : CaptureScope::of(this->Scene.Window);
      return renderer->GetSelector() ? this->select(pipeline, origins)
             : capture
               ? this->capture(pipeline, *capture)
               : pipeline.draw(this->Scene.Window, renderer, this->Options.Draw, this->Report);
    });
  this->Failed = this->Failed || !result.isDone();
  return result;
}

StageResult MapperFrame::capture(Pipeline& pipeline, CaptureScope& scope)
{
  scope.Volumes.push_back({ this->Scene.Volume, this->ArrayName, this->Options.Law, {} });
  const StageResult result = pipeline.capture(this->Scene.Window, this->Scene.Renderer,
    this->Options.Draw, this->Report, scope.Volumes.back().Data);
  if (!result.isDone())
  {
    scope.Volumes.pop_back();
  }
  return result;
}

StageResult MapperFrame::select(Pipeline& pipeline, const CellOrigins& origins)
{
  std::vector<PickedPoint> points;
  const StageResult result = pipeline.select(
    this->Scene.Window, this->Scene.Renderer, this->Options.Draw, origins, this->Report, points);
  this->State.Picking.take(result.isDone(), points, origins, this->Scene.Renderer,
    this->Scene.Volume, pipeline.stages().volume());
  return result;
}

void MapperFrame::end(double& timeToDraw)
{
  if (this->Scene.Renderer->GetSelector())
  {
    return;
  }
  int draws = 0;
  for (Pipeline* pipeline : this->Pipelines)
  {
    draws += pipeline->numberOfDraws();
  }
  if (!this->Failed && !this->Pipelines.empty())
  {
    this->Pipelines.back()->finish();
    if (draws > 1)
    {
      this->Scene.Mapper->UpdateProgress(1.0);
    }
  }
  this->Timer->StopTimer();
  timeToDraw = this->Timer->GetElapsedTime();
  this->record(timeToDraw);
  const std::string invisible = this->describeNothingVisible();
  this->State.LastUndrawn.reportWarning(
    this->Scene.Mapper, invisible.empty() ? this->describeWrongRays() : invisible);
}

// The boundary is drawn whatever the functions show. Blocks that show nothing may do so for
// different reasons; the first one is told.
std::string MapperFrame::describeNothingVisible() const
{
  const bool tells = !this->Failed && !this->Reasons.empty() &&
                     this->Options.Draw.Boundary == BoundaryView::None &&
                     std::none_of(this->Reasons.begin(), this->Reasons.end(),
                       [](const std::string& why) { return why.empty(); });
  return tells ? "Nothing is visible, because " + this->Reasons.front() : std::string();
}

// Where a frame counts. No ray ends so, unless the driver or the march is wrong.
std::string MapperFrame::describeWrongRays() const
{
  MarchCounters all;
  for (const Pipeline* pipeline : this->Pipelines)
  {
    all += pipeline->counted().counters();
  }
  const std::int64_t wrong = all.Lost + all.Guarded;
  return wrong == 0 ? std::string()
                    : "The picture is wrong in up to " + std::to_string(wrong) +
                        " pixels: " + std::to_string(all.Lost) +
                        " rays found no way out of a cell, and " + std::to_string(all.Guarded) +
                        " were stopped since they crossed more cells than there are. Report this "
                        "with the driver's name and version, and try another driver.";
}

FrameResult MapperFrame::resultOf(double seconds) const
{
  FrameResult result;
  result.Drawn = !this->Failed && !this->Pipelines.empty();
  result.IsPicture = this->Options.MarchesPicture;
  result.Seconds = seconds;
  for (const Pipeline* pipeline : this->Pipelines)
  {
    result.Seconds -= this->Options.Draw.View ? 0.0 : pipeline->counted().seconds();
    result.OnlyDrawn = result.OnlyDrawn && pipeline->onlyDrew();
    result.PixelTolerance = std::max(result.PixelTolerance, pipeline->pixelTolerance());
    const Fingerprint& content = pipeline->contentVersion();
    result.ContentVersion.insert(result.ContentVersion.end(), content.begin(), content.end());
  }
  return result;
}

void MapperFrame::record(double seconds)
{
  vtkTetMarchFrameStatistics* statistics = this->State.Statistics;
  FrameResult result = this->resultOf(seconds);
  if (result.Drawn)
  {
    takeMeasures(this->Pipelines.back()->counted(), statistics);
    statistics->SetSeconds(result.Seconds);
    result.ErrorBound = statistics->GetMaximum(vtkTetMarchFrameStatistics::ERROR_BOUND);
  }
  const double used = this->Options.Draw.SampleDistance;
  statistics->SetUsedImageSampleDistance(used);
  SampleDistance& distance = this->State.Distance;
  if (result.Drawn && result.IsPicture && (result.OnlyDrawn || !distance.knowsTime()))
  {
    distance.drawn(used, result.Seconds);
  }
  result.IsPicture = result.IsPicture && used == 1;
  this->State.Accuracy.end(result);
}

} // namespace tetmarch
