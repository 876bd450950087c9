// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The unit distance with which a picture is neither empty nor opaque throughout.
// Optical depth is inversely proportional to the unit distance, so a picture's opacities for one
// unit distance determine those for all. Among covered pixels, the median opacity should be 0.5,
// and the 95th percentile at most 0.97. A pixel is covered if its optical depth is at least a 20th
// of the 95th percentile of those above 0.
#ifndef TetMarchFirstPictureExposure_h
#define TetMarchFirstPictureExposure_h

#include "FirstPicture/Crossings.h"
#include "FirstPicture/FirstFunctions.h"

#include <functional>
#include <optional>

class vtkPiecewiseFunction;

namespace tetmarch
{

// Extinction at a unit distance of 1 by vtkTetMarchSettings::OpacityLaw; an opacity of 1 is treated
// as 0.999.
std::function<double(double value)> extinctionOf(vtkPiecewiseFunction* opacity, bool structuredLaw);

// The unit distance. None if no pixel is covered.
std::optional<double> findExposure(
  const Crossings& crossings, const std::function<double(double)>& extinction);

// The result of findExposure(); if no pixel is covered, the unit distance with which the longest
// path through the data has an optical depth of 1 at an opacity of 1.
double exposedUnitDistance(
  const Crossings& crossings, const std::function<double(double)>& extinction);

struct ExposureOptions
{
  bool StructuredLaw = false; // opacity ends at 0.95, since 1 is opaque at any thickness
  // A pixel with a median length of background has an opacity of 0.12, so that the whole mesh is
  // visible. The background's own opacity is at most 0.05. Otherwise the background is transparent,
  // like the air of an image.
  bool Veil = false;
};

// The opacity of FirstFunctions.h with the power, from 0.5 to 2, that maximizes the entropy of the
// opacities of covered pixels after exposure. Returns the unit distance.
double exposeFirstOpacity(const ValueStatistics& statistics, const Crossings& crossings,
  const ExposureOptions& options, vtkPiecewiseFunction* opacity);

} // namespace tetmarch

#endif
