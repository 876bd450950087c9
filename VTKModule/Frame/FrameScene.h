// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The last frame as a scene of the CPU reference.
#ifndef TetMarchFrameFrameScene_h
#define TetMarchFrameFrameScene_h

#include "Frame/FrameStages.h"
#include "Reference/RayTrace.h"
#include "Reference/ReferenceImage.h"

namespace tetmarch
{

class FrameScene
{
public:
  /**
   * With tables of the property's functions for a level: as the frame has them at the frame's
   * level, or, for the ground truth, of any size. Refers to the stages, whose entry search is
   * prepared. Width and height of the picture are left to set.
   */
  FrameScene(const FrameStages& stages, vtkVolumeProperty* property, const AccuracyLevel& level,
    bool isTruth);
  FrameScene(const FrameScene&) = delete;
  FrameScene& operator=(const FrameScene&) = delete;

  ReferenceScene& scene() { return this->Scene; }
  const ReferenceScene& scene() const { return this->Scene; }
  /** The picture, in the arithmetic of Real: float or double. */
  template <typename Real>
  ReferenceImage render() const
  {
    return renderReference<Real>(this->Scene, this->Level);
  }
  /** The ray of a pixel, counted from the lower left of the picture. */
  RayTrace trace(const TraceOptions& options) const;

private:
  AccuracyLevel Level;
  Components Parts;
  IntegralTable Table;
  ReferenceScene Scene;
};

} // namespace tetmarch

#endif
