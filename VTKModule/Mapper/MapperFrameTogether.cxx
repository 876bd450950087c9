// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The recipe of a frame that several processes draw together.
#include "Mapper/MapperFrame.h"

#include "Mapper/MapperState.h"
#include "Mapper/NothingVisible.h"

#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"

namespace tetmarch
{
namespace
{

// Where this process is after a stage.
PartStatus statusOf(const Pipeline& pipeline, bool goesOn)
{
  PartStatus own;
  own.Error = pipeline.error();
  own.Stopped = !goesOn;
  return own;
}

// Whether all processes go on.
bool goOnTogether(Group& group, Pipeline& pipeline, const PartStatus& own)
{
  const PartStatus all = agreeOn(group, own);
  return all.Error.empty() ? !all.Stopped : pipeline.fail(all.Error);
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

bool MapperFrame::prepareTogether(
  Pipeline& pipeline, const DrawnData& drawn, const std::string& found, GroupState& state)
{
  Group& group = state.Processes;
  state.Shared = {};
  state.Shared.Processes = &group;
  state.Shared.SentBytesBefore = group.sentBytes();
  state.Shared.MostBytes = state.MostVisitBytes;
  WholeVolume whole;
  whole.Level = this->State.Level;
  whole.SampleDistance = this->Options.Draw.SampleDistance;
  const std::string wrong = found.empty() ? this->describeBadForGroup() : found;
  const std::string error =
    agreeOnWhole(group, wrong, vtkUnstructuredGrid::SafeDownCast(drawn.Data), whole);
  if (!error.empty() || whole.IsEmpty)
  {
    return !error.empty() && pipeline.fail(error);
  }
  this->State.Level = whole.Level;
  this->Options.Draw.Level = whole.Level;
  this->Options.Draw.SampleDistance = whole.SampleDistance;
  state.Piece = whole.Piece;
  state.WholeBox = whole.Box;
  pipeline.setPiece(whole.Piece);

  bool stopped = false;
  const Progress progress = [&](double share)
  {
    stopped = stopped || !this->Report(share);
    return !stopped;
  };
  const bool hasPiece =
    pipeline.guarded([&] { return pipeline.updateGeometry(drawn.Data, progress); });
  DrawnScalars scalars;
  std::vector<FiniteRange> ranges;
  const bool hasScalars =
    hasPiece && pipeline.guarded(
                  [&]
                  {
                    const bool chosen =
                      pipeline.chooseScalars(drawn.Data, drawn.Scalars.Array, drawn.Scalars.OfCells,
                        drawn.Vector, this->Scene.Volume->GetProperty(), scalars);
                    ranges = chosen ? pipeline.findRanges(drawn.Data, scalars) : ranges;
                    return chosen;
                  });
  const PartStatus all =
    agreeOnScalars(group, statusOf(pipeline, !stopped), hasScalars, ranges, scalars);
  if (!all.Error.empty() || all.Stopped)
  {
    return !all.Error.empty() && pipeline.fail(all.Error);
  }
  state.Whole = scalars.Whole;
  state.Shared.HasPiece = hasPiece;

  bool goesOn = pipeline.guarded(
    [&] {
      return pipeline.updateScalars(drawn.Data, scalars) && this->prepareTables(pipeline, drawn);
    });
  // Collective: process 0 tells why nothing is visible of all pieces.
  const auto noteTogether = [&]
  {
    const std::string own = stopped ? std::string() : whyNothingIsVisible(pipeline);
    const std::string why = agreeOnNothingVisible(group, hasPiece, own);
    this->noteVisibility(group.rank() == 0 ? why : std::string());
  };
  if (!goOnTogether(group, pipeline, statusOf(pipeline, goesOn)))
  {
    if (pipeline.error().empty())
    {
      noteTogether();
    }
    return false;
  }
  // What all make together is made anew if one has to, and what has failed is tried again by all.
  if (anyOf(group, state.Version != pipeline.sourceVersion()))
  {
    ++state.Generation;
  }
  state.Version.clear();
  pipeline.setGroup(&group, state.Generation);
  goesOn = pipeline.guarded([&] { return this->prepareRays(pipeline, drawn); });
  PartStatus own = statusOf(pipeline, goesOn);
  if (goesOn)
  {
    const Viewport area = pipeline.currentViewport();
    own.Width = area.Width;
    own.Height = area.Height;
  }
  const bool ready = goOnTogether(group, pipeline, own);
  if (pipeline.error().empty())
  {
    noteTogether();
  }
  if (!ready)
  {
    return false;
  }
  state.Version = pipeline.sourceVersion();
  this->Options.Draw.RaysEnd = anyOf(group, pipeline.endsRays(this->Scene.Renderer));
  this->Options.Draw.Shared = &state.Shared;
  return true;
}

} // namespace tetmarch
