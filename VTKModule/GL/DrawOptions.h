// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// How a frame is drawn.
#ifndef TetMarchGLDrawOptions_h
#define TetMarchGLDrawOptions_h

#include "Diagnostics/BoundaryView.h"
#include "Diagnostics/MeasureView.h"
#include "Optics/AccuracyLevel.h"
#include "Processes/SharedPicture.h"
#include "Variants/ShaderStage.h"

#include <array>

namespace tetmarch
{

class PeelHooks;

struct DrawOptions
{
  AccuracyLevel Level = DefaultAccuracy;
  bool Diagnostics = false;
  ShaderStage Stage = ShaderStage::Automatic; // of what is not peeled
  double MostSecondsPerDraw = 0;              // 0: no limit
  double MostLightSeconds = 0;                // of a frame, for light at vertices; 0: no limit
  const MeasureView* View = nullptr;          // drawn instead of the picture
  BoundaryView Boundary = BoundaryView::None; // the same
  double SampleDistance = 1; // between rays, in pixels; 1 with diagnostics or a view
  double PixelTolerance = 0; // 0: a ray for each pixel; without peels or views of other measures
                             // than the error; ignored with several processes
  /** A factor of the picture's colours, and what is added to opaque ones; views and diagnostics
   * have the colours before that. */
  std::array<float, 2> ColorWindow{ { 1, 0 } };
  const PeelHooks* Peeling = nullptr; // only parts of rays are drawn, without diagnostics or a view
  SharedPicture* Shared = nullptr;    // of several processes; without diagnostics, a view or peels
  bool RaysEnd = false;               // some process has opaque geometry
  double PickOpacity = 0.5;           // of a ray at the point where the volume is picked
};

} // namespace tetmarch

#endif
