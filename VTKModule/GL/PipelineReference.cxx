// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The last frame once more, by the CPU: its picture, or the ray of one of its pixels.
#include "GL/Pipeline.h"

#include "Caching/WithinMemory.h"
#include "Reference/RayTrace.h"

#include "vtkOpenGLRenderWindow.h"

#include <sstream>

namespace tetmarch
{

// Calls `use` with what the last frame showed, but for the volume, and with tables for a level.
bool Pipeline::useReferenceScene(vtkVolumeProperty* property, OpacityLaw law,
  const AccuracyLevel& level, const std::function<void(ReferenceScene&)>& use)
{
  if (!this->Window || this->Area.Width <= 0 || this->Area.Height <= 0)
  {
    return this->fail("There is no frame to compare with: render the window first, with a ray "
                      "a pixel and without peels of translucent geometry.");
  }
  const std::string error = this->prepareEntrySearch();
  if (!error.empty())
  {
    return this->fail(error);
  }
  const std::string shortage = withinMemory("the reference picture",
    [&]
    {
      const std::vector<float> depths = this->Passes.opaqueDepths(this->Window);
      Components parts = this->Tables.components();
      const IntegralTable table = makeTables(property, this->tableInput(law), level, parts);
      ReferenceScene scene;
      scene.NanShown = this->NanShown;
      scene.Table = &table;
      scene.Camera = this->Camera;
      scene.Width = this->Area.Width;
      scene.Height = this->Area.Height;
      scene.WindowDepths = depths.empty() ? nullptr : depths.data();
      scene.Cut = this->Cut;
      scene.Effects = &this->Effects.data();
      scene.Blend = &this->Blend;
      scene.Parts = &parts;
      use(scene);
    });
  return shortage.empty() || this->fail(shortage);
}

bool Pipeline::renderReference(
  vtkVolumeProperty* property, OpacityLaw law, const Progress& progress, ReferenceImage& image)
{
  this->Error.clear();
  const bool done = this->useReferenceScene(property, law, GroundTruthAccuracy,
    [&](ReferenceScene& scene)
    {
      scene.Report = progress;
      image = this->Source.renderReference(scene, GroundTruthAccuracy);
    });
  return done && !image.Stopped;
}

bool Pipeline::traceRay(
  vtkVolumeProperty* property, OpacityLaw law, const TraceOptions& options, RayTrace& trace)
{
  const Viewport& area = this->Area;
  const bool drawn = area.Width > 0 && area.Height > 0;
  TraceOptions ofFrame = options;
  ofFrame.X -= area.X;
  ofFrame.Y -= area.Y;
  if (drawn &&
      (ofFrame.X < 0 || ofFrame.Y < 0 || ofFrame.X >= area.Width || ofFrame.Y >= area.Height))
  {
    std::ostringstream error;
    error << "The pixel (" << options.X << ", " << options.Y << ") is outside the last frame, of "
          << area.Width << " x " << area.Height << " pixels from (" << area.X << ", " << area.Y
          << ") on.";
    return this->fail(error.str());
  }
  return this->useReferenceScene(property, law, options.Level,
    [&](ReferenceScene& scene)
    {
      scene.ExactLight = options.ExactLight || this->Passes.samplesShadows();
      trace = this->Source.traceRay(scene, ofFrame);
    });
}

} // namespace tetmarch
