// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/ContentOf.h"

#include "Frame/FrameStages.h"
#include "GL/MarchPass.h"

#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <cmath>

namespace tetmarch
{
namespace
{

// Whatever is seen in the renderer and may end rays, and when it changed last.
Fingerprint surroundingsIn(vtkRenderer* renderer)
{
  Fingerprint version;
  vtkCollectionSimpleIterator it;
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    if (prop->GetVisibility() && vtkProp3D::SafeDownCast(prop) && !vtkVolume::SafeDownCast(prop))
    {
      version.push_back(reinterpret_cast<std::uintptr_t>(prop));
      version.push_back(static_cast<std::uintptr_t>(prop->GetRedrawMTime()));
    }
  }
  return version;
}

std::array<std::array<double, 2>, 8> cornersOf(const VolumeFrame& frame, const View& camera)
{
  const Vector3& high = frame.HalfExtent;
  const auto& m = camera.NormalizedToClip;
  std::array<std::array<double, 2>, 8> corners;
  for (unsigned i = 0; i < corners.size(); ++i)
  {
    const auto row = [&](int r)
    {
      return m[4 * r + 3] + (i & 1u ? 1 : -1) * m[4 * r] * high[0] +
             (i & 2u ? 1 : -1) * m[4 * r + 1] * high[1] +
             (i & 4u ? 1 : -1) * m[4 * r + 2] * high[2];
    };
    const double w = row(3);
    corners[i] = { { w > 0 ? row(0) / w : HUGE_VAL, w > 0 ? row(1) / w : HUGE_VAL } };
  }
  return corners;
}

} // namespace

void add(Fingerprint& fingerprint, const Clipping& cut)
{
  for (const auto& plane : cut.Planes)
  {
    addAll(fingerprint, plane);
  }
  addAll(fingerprint, cut.CroppingLow);
  addAll(fingerprint, cut.CroppingHigh);
  fingerprint.push_back(static_cast<std::uintptr_t>(cut.CroppingFlags));
}

PictureContent contentOf(const Fingerprint& shown, const MarchInputs& inputs, vtkRenderer* renderer)
{
  PictureContent content;
  content.Version = shown;
  content.Version.push_back(static_cast<std::uintptr_t>(inputs.Key.bits()));
  content.Version.push_back(inputs.ByCompute ? 1 : 0);
  add(content.Version, inputs.Stages->cuts());
  add(content.Version, inputs.Stages->samples().Distance);
  add(content.Version, inputs.Level.ErrorTolerance);
  content.Version.push_back(static_cast<std::uintptr_t>(inputs.Level.MostTrials));
  const LightUniforms& lights = inputs.Stages->effects().data().Lights;
  add(content.Version, lights.Tolerance);
  if (inputs.Key.SampledShadows)
  {
    for (const auto& source : lights.ShadowSources)
    {
      addAll(content.Version, source);
    }
    add(content.Version, lights.Reach);
    content.Version.push_back(static_cast<std::uintptr_t>(lights.TurnsOfSample));
    content.Version.push_back(static_cast<std::uintptr_t>(lights.OcclusionDirections));
    add(content.Version, lights.OcclusionRadius);
    add(content.Version, inputs.Stages->effects().data().Opaque.version());
  }
  if (inputs.Key.OpaqueDepth)
  {
    content.Surroundings = surroundingsIn(renderer);
  }
  content.IsLayer = inputs.Key.Peeled;
  content.Corners = cornersOf(inputs.Stages->volume().frame(), inputs.Stages->camera());
  return content;
}

} // namespace tetmarch
