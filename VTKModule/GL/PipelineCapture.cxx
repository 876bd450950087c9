// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The last stage of a frame that is captured for a page instead of drawn.
#include "GL/Pipeline.h"

#include "Caching/WithinMemory.h"
#include "Volume/StructuredVolume.h"
#include "Volume/TetVolume.h"

#include "vtkOpenGLRenderWindow.h"

namespace tetmarch
{
namespace
{

std::vector<std::uint32_t> cellsOf(const TetVolume& volume)
{
  std::vector<std::uint32_t> cells(volume.mesh().numberOfTets());
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    cells[i] = static_cast<std::uint32_t>(volume.cellOf(static_cast<std::uint32_t>(i), Vector3{}));
  }
  return cells;
}

// What tells the cell of the data in which a ray is picked.
void captureCells(const MarchedVolume& volume, CapturedVolume& captured)
{
  if (const auto* image = dynamic_cast<const StructuredVolume*>(&volume))
  {
    captured.DataPlanes = image->dataPlanes();
  }
  if (const auto* mesh = dynamic_cast<const TetVolume*>(&volume))
  {
    captured.Cells = cellsOf(*mesh);
  }
}

bool hasVisibleFaces(const MarchedVolume& volume)
{
  const auto* mesh = dynamic_cast<const TetVolume*>(&volume);
  return mesh && !mesh->visiblePart().Faces.empty();
}

} // namespace

StageResult Pipeline::capture(vtkOpenGLRenderWindow* window, vtkRenderer* renderer,
  const DrawOptions& options, const Progress& progress, CapturedVolume& captured)
{
  // The page lists entries by itself. Where it can't, its rays search them in the hierarchy.
  this->Stages.beginBeforeVolume();
  std::string error = this->Stages.prepareEntrySearch();
  error = error.empty() ? this->upload(window) : error;
  if (!error.empty())
  {
    return { error };
  }
  MarchInputs inputs = this->inputsOf(options, renderer, this->currentViewport());
  inputs.ByCompute = false;
  inputs.MostLightSeconds = 0;
  inputs.Key.OpaqueDepth = false;
  inputs.Key.Peeled = false;
  const bool entersVisible = inputs.Key.filtered().VisiblePart;
  // Rays that don't enter the visible part pass the transparent cells.
  inputs.Key.TransparentRanges = inputs.Key.TransparentRanges || entersVisible;
  inputs.Key.EntryLists = false;
  inputs.Key = inputs.Key.filtered();
  if (inputs.Key.SplitCells)
  {
    return { "The mesh has too many tetrahedra for a page. Extract or coarsen a part of it." };
  }
  StageResult result;
  const std::string shortage = withinMemory("the page",
    [&]
    {
      error = this->EffectsOnGpu.update(window, this->Stages.effects(), inputs.Key);
      const DrawContext context{ window, progress };
      result = StageResult{ error }.then(
        [&] { return this->Passes.capture(context, inputs, captured.Program); });
      if (entersVisible && hasVisibleFaces(this->Stages.volume()))
      {
        result = result.then(
          [&] { return this->Passes.captureVisiblePart(context, inputs, captured.Program); });
      }
      captured.Key = inputs.Key;
      captured.Frame = this->Stages.volume().frame();
      captured.Level = inputs.Level;
      captured.Range = this->Stages.volume().range();
      captured.ExtraRanges = this->Stages.volume().extraRanges();
      captureCells(this->Stages.volume(), captured);
    });
  return shortage.empty() ? result : StageResult{ shortage };
}

} // namespace tetmarch
