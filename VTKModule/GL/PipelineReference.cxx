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

// Calls `use` with the last frame's scene, which has tables for a level.
StageResult Pipeline::useReferenceScene(vtkVolumeProperty* property, const AccuracyLevel& level,
  bool isTruth, const std::function<void(FrameScene&)>& use)
{
  if (!this->Window || this->Area.Width <= 0 || this->Area.Height <= 0)
  {
    return { "There is no frame to compare with: render the window first, with a ray a pixel and "
             "without peels of translucent geometry." };
  }
  const std::string error = this->Stages.prepareEntrySearch();
  if (!error.empty())
  {
    return { error };
  }
  const std::string shortage = withinMemory("the reference picture",
    [&]
    {
      const std::vector<float> depths = this->Passes.opaqueDepths(this->Window);
      FrameScene made(this->Stages, property, level, isTruth);
      ReferenceScene& scene = made.scene();
      scene.Width = this->Area.Width;
      scene.Height = this->Area.Height;
      scene.WindowDepths = depths.empty() ? nullptr : depths.data();
      use(made);
    });
  return { shortage };
}

StageResult Pipeline::renderReference(vtkVolumeProperty* property, const AccuracyLevel& level,
  const Progress& progress, ReferenceImage& image)
{
  StageResult result = this->useReferenceScene(property, level, true,
    [&](FrameScene& made)
    {
      made.scene().Report = progress;
      image = made.render<double>();
    });
  result.Stopped = image.Stopped;
  return result;
}

StageResult Pipeline::traceRay(
  vtkVolumeProperty* property, const TraceOptions& options, RayTrace& trace)
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
    return { error.str() };
  }
  return this->useReferenceScene(property, options.Level, options.IsTruth,
    [&](FrameScene& made)
    {
      made.scene().Light = options.IsTruth                 ? LightAt::Points
                           : this->Passes.samplesShadows() ? LightAt::Faces
                                                           : LightAt::Vertices;
      trace = made.trace(ofFrame);
    });
}

} // namespace tetmarch
