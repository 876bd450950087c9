// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The recipe of a frame that several processes draw together.
#include "Mapper/MapperFrame.h"

#include "Frame/NothingVisible.h"
#include "Mapper/MapperState.h"
#include "Volume/TetVolume.h"

#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"

namespace tetmarch
{
namespace
{

// Where all processes are after a stage.
StageResult agreeOn(Group& group, const StageResult& own, const Viewport& area = {})
{
  PartStatus status;
  status.Error = own.Error;
  status.Stopped = own.Stopped;
  status.Width = area.Width;
  status.Height = area.Height;
  const PartStatus all = tetmarch::agreeOn(group, status);
  return { all.Error, all.Stopped };
}

} // namespace

// What one process alone can draw.
std::string MapperFrame::describeBadForGroup() const
{
  if (this->isPeeled())
  {
    return "Volumes of which several processes have pieces can't be drawn between translucent "
           "surfaces. Choose vtkRenderer::UseDepthPeelingForVolumesOff().";
  }
  if (this->Options.Draw.View || this->Options.Draw.Boundary != BoundaryView::None)
  {
    return "The view mode shows a measure or the boundary, which is known of the piece of one "
           "process alone. Choose SetViewModeToPicture(), or draw in one process.";
  }
  return {};
}

// The whole volume, and how it is drawn.
StageResult MapperFrame::agreeOnFrame(
  const DrawnData& drawn, const std::string& found, GroupState& state)
{
  Group& group = state.Processes;
  state.Shared = {};
  state.Shared.Processes = &group;
  state.Shared.SentBytesBefore = group.sentBytes();
  state.Shared.MostBytes = state.MostVisitBytes;
  WholeVolume whole;
  whole.Level = this->State.Level;
  whole.SampleDistance = this->Options.Draw.SampleDistance;
  whole.Piece = drawn.Volume.Piece;
  const std::string wrong = found.empty() ? this->describeBadForGroup() : found;
  const std::string error =
    agreeOnWhole(group, wrong, vtkUnstructuredGrid::SafeDownCast(drawn.Volume.Data), whole);
  if (error.empty() && !whole.IsEmpty)
  {
    this->State.Level = whole.Level;
    this->Options.Draw.Level = whole.Level;
    this->Options.Draw.SampleDistance = whole.SampleDistance;
    state.Piece = whole.Piece;
    state.WholeBox = whole.Box;
  }
  return { error, whole.IsEmpty };
}

// Stages up to the tables. A process whose piece shows nothing goes on with the others.
StageResult MapperFrame::prepareScalars(
  TetVolume& piece, Pipeline& pipeline, FrameInput& input, GroupState& state)
{
  Group& group = state.Processes;
  bool stopped = false;
  const Progress progress = [&](double share)
  {
    stopped = stopped || !this->Report(share);
    return !stopped;
  };
  StageResult own = guarded([&] { return pipeline.updateGeometry(input, progress); });
  const bool hasPiece = own.isDone();
  DrawnScalars scalars;
  std::vector<FiniteRange> ranges;
  if (hasPiece)
  {
    own = guarded(
      [&]
      {
        const StageResult chosen = FrameStages::chooseScalars(input, scalars);
        ranges = chosen.isDone() ? piece.rangesOf(input.Drawn.Volume.Data, scalars) : ranges;
        return chosen;
      });
  }
  const bool hasScalars = own.isDone();
  PartStatus status;
  status.Error = own.Error;
  status.Stopped = stopped;
  const PartStatus all = agreeOnScalars(group, status, hasScalars, ranges, scalars);
  if (!all.Error.empty() || all.Stopped)
  {
    return { all.Error, all.Stopped };
  }
  state.Whole = scalars.Whole;
  state.Shared.HasPiece = hasPiece;
  own = guarded([&] { return pipeline.stages().updateScalars(input, scalars); });
  const StageResult agreed = agreeOn(group, own);
  if (agreed.Stopped && agreed.Error.empty())
  {
    this->noteDistributed(pipeline, state);
  }
  return agreed;
}

// Collective: process 0 tells why nothing is visible of all pieces.
void MapperFrame::noteDistributed(const Pipeline& pipeline, GroupState& state)
{
  const std::string why = agreeOnNothingVisible(
    state.Processes, state.Shared.HasPiece, whyNothingIsVisible(pipeline.stages()));
  this->noteVisibility(state.Processes.rank() == 0 ? why : std::string());
}

StageResult MapperFrame::prepareDistributed(TetVolume& piece, Pipeline& pipeline,
  const DrawnData& drawn, const std::string& found, GroupState& state)
{
  Group& group = state.Processes;
  const StageResult begun = this->agreeOnFrame(drawn, found, state);
  if (!begun.isDone())
  {
    return begun;
  }
  FrameInput input = this->inputOf(drawn);
  input.Drawn.Volume.Piece = state.Piece;
  input.Drawn.Whole.clear(); // it is agreed on anew
  const StageResult prepared = this->prepareScalars(piece, pipeline, input, state);
  if (!prepared.isDone())
  {
    return prepared;
  }
  // What all make together is made anew if one has to, and what has failed is tried again by all.
  if (anyOf(group, state.Version != piece.version()))
  {
    ++state.Generation;
  }
  state.Version.clear();
  pipeline.stages().setGroup(&group, state.Generation);
  const StageResult own = guarded([&] { return pipeline.updateRays(this->Scene.Window, input); });
  const StageResult ready =
    agreeOn(group, own, own.isDone() ? pipeline.currentViewport() : Viewport());
  if (ready.Error.empty())
  {
    this->noteDistributed(pipeline, state);
  }
  if (ready.isDone())
  {
    state.Version = piece.version();
    this->Options.Draw.RaysEnd = anyOf(group, pipeline.endsRays(this->Scene.Renderer));
    this->Options.Draw.Shared = &state.Shared;
  }
  return ready;
}

} // namespace tetmarch
