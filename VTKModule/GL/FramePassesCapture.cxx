// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the shaders of a frame read, for a page that draws it.
#include "GL/FramePasses.h"

#include "Frame/FrameStages.h"
#include "GL/EntryListTextures.h"
#include "View/RayPoints.h"

namespace tetmarch
{

StageResult FramePasses::capture(
  const DrawContext& context, MarchInputs inputs, CapturedProgram& program)
{
  StageResult result = this->updateLight(context, inputs);
  inputs.RayPoints = rayPoints(inputs.Stages->camera(), inputs.Stages->volume().frame());
  const VariantKey asChosen = inputs.Key;
  VariantKey fast = asChosen;
  fast.PointSampled = false;
  fast.Adaptive = false;
  VariantKey adaptive = fast;
  adaptive.Adaptive = true;
  for (const VariantKey& key : { asChosen, adaptive, fast })
  {
    for (const bool counts : { false, true })
    {
      inputs.Key = key;
      inputs.Key.Diagnostics = counts;
      inputs.Key = inputs.Key.filtered();
      result = result.then(
        [&] { return StageResult{ this->March.capture(context.Window, inputs, program) }; });
    }
  }
  return result;
}

StageResult FramePasses::captureVisiblePart(
  const DrawContext& context, MarchInputs inputs, CapturedProgram& program)
{
  inputs.Key = inputs.Key.ofPick(); // the simplest variant that reads it
  inputs.Key.OpaqueDepth = false;
  inputs.Key.EntryLists = true;
  inputs.Key.VisiblePart = true;
  inputs.Key = inputs.Key.filtered();
  StageResult result{ this->findRays(context.Window, inputs.Area, inputs) };
  result = result.then(
    [&] { return StageResult{ this->March.capture(context.Window, inputs, program) }; });
  EntryListTextures::removeFrom(program); // the page makes its own
  return result;
}

} // namespace tetmarch
