// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The unit distance with which a picture is neither empty nor a slab.
//
// Optical depth is inverse to the unit distance, so a picture's opacities are known for all unit
// distances once they are for one. Of the pixels that show anything, the median is to be half
// opaque, and the 95th percentile not above 0.97. A pixel shows something if its optical depth is
// at least a 20th of that of the 95th percentile of those that have any.
#ifndef TetMarchFirstPictureExposure_h
#define TetMarchFirstPictureExposure_h

#include "FirstPicture/Crossings.h"
#include "FirstPicture/FirstFunctions.h"

#include <functional>
#include <optional>

class vtkPiecewiseFunction;

namespace tetmarch
{

// Extinction at a unit distance of 1 as vtkTetMarchSettings::OpacityLaw has it; an opacity of 1
// counts as 0.999.
std::function<double(double value)> extinctionOf(vtkPiecewiseFunction* opacity, bool structuredLaw);

// The unit distance. None if no pixel shows anything.
std::optional<double> findExposure(
  const Crossings& crossings, const std::function<double(double)>& extinction);

// Of findExposure(); where nothing is shown, with which the longest way through the data has an
// optical depth of 1 at an opacity of 1.
double exposedUnitDistance(
  const Crossings& crossings, const std::function<double(double)>& extinction);

struct ExposureOptions
{
  bool StructuredLaw = false; // opacity ends at 0.95, since 1 means a wall
  // A pixel that sees a median length of background has an opacity of 0.12: so the whole of a mesh
  // is seen. The background's own opacity is 0.05 at most. Without it the background is clear, as
  // the air of an image is.
  bool Veil = false;
};

// The opacity of FirstFunctions.h with the power, from 0.5 to 2, that shows most: exposed, its
// pixels before the data have the opacities with the greatest entropy. Returns the unit distance.
double exposeFirstOpacity(const ValueStatistics& statistics, const Crossings& crossings,
  const ExposureOptions& options, vtkPiecewiseFunction* opacity);

} // namespace tetmarch

#endif
