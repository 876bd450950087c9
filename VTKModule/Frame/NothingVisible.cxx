// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/NothingVisible.h"

#include "FirstPicture/RangeText.h"
#include "Frame/FrameStages.h"
#include "Scalars/SeenScalars.h"
#include "View/ClippedBox.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

std::string valuesOf(const ScalarRange& range)
{
  const auto [low, high] = rangeText(range.Low, range.High);
  return "the values of the array, " + low + " to " + high;
}

bool showsAny(const IntegralTable& table, const ScalarRange& range)
{
  return SeenScalars(table, range).between(0, range.High > range.Low ? 1 : 0);
}

// Whether the functions have extinction at a scalar within its range.
bool showAnyScalar(const FrameStages& stages)
{
  const TransferTables& tables = stages.tables();
  const Components& parts = tables.components();
  bool any = showsAny(tables.first(), stages.volume().range());
  for (std::size_t k = 0; parts.isIndependent() && k < parts.Tables.size(); ++k)
  {
    any = any || showsAny(parts.Tables[k], parts.ExtraRanges[k]);
  }
  return any;
}

std::string whyNoSurface(const Blending& blending, const ScalarRange& range)
{
  if (blending.IsoValues.empty())
  {
    return "there are no isosurface values. Set some (vtkVolumeProperty::GetIsoSurfaceValues()).";
  }
  const float high = range.High > range.Low ? 1.0f : 0.0f;
  bool inRange = false, seen = false;
  for (std::size_t i = 0; i < blending.IsoValues.size(); ++i)
  {
    const bool isIn = blending.IsoValues[i] >= 0 && blending.IsoValues[i] <= high;
    inRange = inRange || isIn;
    seen = seen || (isIn && blending.IsoColors[i][3] > 0);
  }
  return !inRange ? "no isosurface value lies among " + valuesOf(range) +
                      ". Choose isosurface values between these."
         : !seen ? "the opacity is 0 at the isosurface values. Change the scalar opacity function."
                 : std::string();
}

// By the transfer functions and what the blend mode shows of them.
std::string whyNoValue(const FrameStages& stages)
{
  const Blending& blending = stages.blending();
  const ScalarRange& range = stages.volume().range();
  if (blending.Mode == BlendMode::Average &&
      (blending.AverageRange[1] < 0 || blending.AverageRange[0] > 1))
  {
    return "the range of the values that are averaged (AverageIPScalarRange) has none of " +
           valuesOf(range) + ". Choose a range with some.";
  }
  if (blending.isSum() || stages.showsNan())
  {
    return {};
  }
  const std::string noSurface =
    blending.isIsoSurface() ? whyNoSurface(blending, range) : std::string();
  // Of scalars of cells surfaces lie between cells, none of which has a value that is shown.
  if (blending.isIsoSurface())
  {
    return noSurface;
  }
  if (!showAnyScalar(stages))
  {
    return "the opacity is 0 for all of " + valuesOf(range) +
           ". Change the scalar opacity function, or choose another array.";
  }
  return stages.volume().showsNothing()
           ? "no cell has a value that is shown" +
               std::string(range.AllFinite ? "" : " without one that is not a finite number") +
               ": the transfer functions show nothing of what cells have of " + valuesOf(range) +
               ". Change them."
           : std::string();
}

std::string whyNothingIsLeft(const FrameStages& stages)
{
  const Clipping& cuts = stages.cuts();
  const auto& box = stages.volume().frame().HalfExtent;
  return leavesNothing(cuts, box)
           ? "clipping planes and cropping leave nothing of the volume. Move them, or remove them "
             "(RemoveAllClippingPlanes(), CroppingOff())."
           : std::string();
}

} // namespace

std::string whyNothingIsVisible(const FrameStages& stages)
{
  const MarchedVolume& volume = stages.volume();
  if (volume.isEmpty())
  {
    return {};
  }
  if (volume.isHidden())
  {
    return "every cell is hidden by an array of ghost cells or points (vtkGhostType). Change or "
           "remove the array.";
  }
  if (!volume.range().AnyFinite && !stages.showsNan())
  {
    return "none of the scalars is a finite number. Choose another array, or have cells without "
           "such numbers drawn in the NaN color by SetDrawNanCells(true); in ParaView, by Draw Nan "
           "Cells.";
  }
  const std::string why = whyNoValue(stages);
  return why.empty() ? whyNothingIsLeft(stages) : why;
}

} // namespace tetmarch
