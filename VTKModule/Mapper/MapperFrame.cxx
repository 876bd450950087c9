// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mapper/MapperFrame.h"

#include "Mapper/FrameMeasures.h"
#include "Mapper/MapperState.h"

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"

namespace tetmarch
{

MapperFrame::MapperFrame(const MapperScene& scene, MapperState& state, const BlendOptions& blend)
  : Scene(scene)
  , State(state)
  , Report(
      [scene](double share)
      {
        scene.Mapper->UpdateProgress(share);
        return !scene.Renderer->GetRenderWindow()->CheckAbortStatus();
      })
  , Hooks(scene.Volume, scene.Mapper)
  , Options(state.Settings.get(), static_cast<BlendMode>(blend.Mode), scene.Renderer, state.Level,
      this->Hooks, state.ViewTable)
{
  this->Timer->StartTimer();
  this->Options.chooseSampleDistance(
    state.Settings.get(), state.Distance, scene.Volume->GetAllocatedRenderTime());
}

MapperFrame::~MapperFrame() = default;

void MapperFrame::draw(Pipeline& pipeline, const DrawnData& drawn, const CellOrigins& origins)
{
  vtkRenderer* renderer = this->Scene.Renderer;
  this->Drawn = drawn.Scalars.Array && this->prepare(pipeline, drawn) &&
                (renderer->GetSelector() ? this->select(pipeline, origins)
                                         : pipeline.draw(this->Scene.Window, renderer,
                                             this->Options.Draw, this->Report));
}

bool MapperFrame::prepare(Pipeline& pipeline, const DrawnData& drawn)
{
  vtkRenderer* renderer = this->Scene.Renderer;
  vtkVolume* volume = this->Scene.Volume;
  vtkVolumeProperty* property = volume->GetProperty();
  const FrameOptions& options = this->Options;
  return pipeline.updateGeometry(drawn.Data, this->Report) &&
         pipeline.updateScalars(
           drawn.Data, drawn.Scalars.Array, drawn.Scalars.OfCells, drawn.Vector, property) &&
         pipeline.updateBlending(property, drawn.Blend) &&
         pipeline.updateTables(property, options.Law, this->State.Level, options.DrawNanCells) &&
         pipeline.updateEffects(renderer, volume, options.Effects) &&
         pipeline.updateView(renderer, volume) && pipeline.updateClipping(volume, drawn.Cuts) &&
         pipeline.upload(this->Scene.Window);
}

bool MapperFrame::select(Pipeline& pipeline, const CellOrigins& origins)
{
  std::vector<PickedPoint> points;
  const bool drawn = pipeline.select(
    this->Scene.Window, this->Scene.Renderer, this->Options.Draw, origins, this->Report, points);
  this->State.Picking.take(
    drawn, points, this->Scene.Renderer, this->Scene.Volume, pipeline.source());
  return drawn;
}

void MapperFrame::end(Pipeline& pipeline, double& timeToDraw)
{
  if (this->Scene.Renderer->GetSelector())
  {
    return;
  }
  if (this->Drawn)
  {
    pipeline.finish();
    if (pipeline.numberOfDraws() > 1)
    {
      this->Scene.Mapper->UpdateProgress(1.0);
    }
  }
  this->Timer->StopTimer();
  timeToDraw = this->Timer->GetElapsedTime();
  this->record(pipeline, timeToDraw);
}

void MapperFrame::record(const Pipeline& pipeline, double seconds)
{
  vtkTetMarchFrameStatistics* statistics = this->State.Statistics;
  const DrawOptions& options = this->Options.Draw;
  const double aside = options.View ? 0.0 : pipeline.counted().seconds();
  const double ownSeconds = seconds - aside;
  if (this->Drawn)
  {
    takeMeasures(pipeline.counted(), statistics);
    statistics->SetSeconds(ownSeconds);
  }
  statistics->SetUsedImageSampleDistance(options.SampleDistance);
  const bool isPicture = this->Options.MarchesPicture;
  SampleDistance& distance = this->State.Distance;
  if (this->Drawn && isPicture && (pipeline.onlyDrew() || !distance.knowsTime()))
  {
    distance.drawn(options.SampleDistance, ownSeconds);
  }
  this->State.Accuracy.end(
    { this->Drawn, isPicture && options.SampleDistance == 1, pipeline.onlyDrew(), ownSeconds,
      statistics->GetMaximum(vtkTetMarchFrameStatistics::ERROR_BOUND), pipeline.subject() });
}

} // namespace tetmarch
