// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The last stage of a frame in which a vtkHardwareSelector reads numbers instead of a picture.
#include "GL/Pipeline.h"

#include "Caching/WithinMemory.h"
#include "GL/ContentOf.h"
#include "Picking/SelectedCells.h"

#include "vtkHardwareSelector.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

// The least share of light that a float difference from 1 can hold.
constexpr double LeastFloatShare = 1.0 / (1 << 24);

// The part of the selector's area, corners included, that lies in the viewport.
Viewport selectedPart(vtkHardwareSelector* selector, const Viewport& viewport)
{
  const unsigned int* area = selector->GetArea();
  const int left = std::max(static_cast<int>(area[0]), viewport.X);
  const int bottom = std::max(static_cast<int>(area[1]), viewport.Y);
  const int right = std::min(static_cast<int>(area[2]), viewport.X + viewport.Width - 1);
  const int top = std::min(static_cast<int>(area[3]), viewport.Y + viewport.Height - 1);
  return { left, bottom, right - left + 1, top - bottom + 1 };
}

} // namespace

// What the picked points of the pixels in a part of the inputs' area are found by, but for opaque
// geometry: a selector draws what it needs of that in each of its passes.
Fingerprint Pipeline::pickVersion(const MarchInputs& inputs, const Viewport& part) const
{
  Fingerprint version = this->Stages.contentVersion();
  version.push_back(static_cast<std::uintptr_t>(this->stageRuns()));
  version.push_back(static_cast<std::uintptr_t>(inputs.Key.bits()));
  addAll(version, this->Stages.camera().NormalizedToClip);
  addAll(version, this->Stages.camera().ThicknessMatrix);
  add(version, this->Stages.cuts());
  for (const Viewport& place : { inputs.Area, part })
  {
    addAll(version, std::array<int, 4>{ { place.X, place.Y, place.Width, place.Height } });
  }
  add(version, inputs.Level.ErrorTolerance);
  return version;
}

StageResult Pipeline::findPicked(const DrawContext& context, MarchInputs inputs,
  const Viewport& part, std::vector<PickedPoint>& points)
{
  // What the picture needs stays on the GPU.
  StageResult result{ this->EffectsOnGpu.update(
    context.Window, this->Stages.effects(), inputs.Key) };
  inputs.Key = this->withEntries(inputs.Key.ofPick());
  result =
    result.then([&] { return StageResult{ this->prepareSearch(context.Window, inputs.Key) }; });
  return result.then([&] { return StageResult{ describeUnfit(inputs, 0) }; })
    .then([&] { return this->Passes.pick(context, inputs, part, points); });
}

StageResult Pipeline::select(vtkOpenGLRenderWindow* window, vtkRenderer* renderer,
  const DrawOptions& options, const CellOrigins& origins, const Progress& progress,
  std::vector<PickedPoint>& points)
{
  const Viewport area = this->currentViewport();
  const Viewport part = selectedPart(renderer->GetSelector(), area);
  if (part.Width <= 0 || part.Height <= 0)
  {
    return {};
  }
  MarchInputs inputs = this->inputsOf(options, renderer, area);
  inputs.Level = PickAccuracy;
  inputs.Level.ErrorTolerance = std::max(1 - options.PickOpacity, LeastFloatShare);
  vtkHardwareSelector* selector = renderer->GetSelector();
  const auto goOn = [&](double share) { return progress(share) && this->Window == window; };
  StageResult result;
  const std::string shortage = withinMemory("what is selected",
    [&]
    {
      const Fingerprint version = this->pickVersion(inputs, part);
      if (const std::vector<PickedPoint>* found = this->Found.find(selector, version))
      {
        points = *found;
      }
      else
      {
        result = this->findPicked({ window, goOn }, inputs, part, points);
        if (result.isDone())
        {
          this->Found.keep(selector, version, points);
        }
      }
      result = result.then(
        [&]
        {
          return StageResult{ this->Selected.draw(window, area, part,
            selectionTexels(selector, points, origins, this->Stages.camera())) };
        });
    });
  this->forgetErrorsOfReleasing(window);
  return shortage.empty() ? result : StageResult{ shortage };
}

} // namespace tetmarch
