// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/FrameScene.h"

#include <limits>

namespace tetmarch
{

FrameScene::FrameScene(
  const FrameStages& stages, vtkVolumeProperty* property, const AccuracyLevel& level, bool isTruth)
  : Level(level)
  , Parts(stages.tables().components())
{
  TableInput input = stages.tableInput();
  input.MostEntries = isTruth ? std::numeric_limits<std::uint64_t>::max() : input.MostEntries;
  this->Table = makeTables(property, input, level, this->Parts);
  stages.volume().addTo(this->Scene);
  this->Scene.NanShown = stages.showsNan();
  this->Scene.Table = &this->Table;
  this->Scene.Camera = stages.camera();
  this->Scene.Cut = stages.cuts();
  this->Scene.Samples = stages.samples();
  this->Scene.Effects = &stages.effects().data();
  this->Scene.Blend = &stages.blending();
  this->Scene.Parts = &this->Parts;
}

RayTrace FrameScene::trace(const TraceOptions& options) const
{
  return options.InDouble ? traceRay<double>(this->Scene, this->Level, options.X, options.Y)
                          : traceRay<float>(this->Scene, this->Level, options.X, options.Y);
}

} // namespace tetmarch
