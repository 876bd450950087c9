// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A first picture without asking the user anything.
 *
 * Each cell counts by the area that it covers in a picture, volume^(2/3), with the volume of its
 * bounding box, since meshes are finest at walls, where values are extreme, and those few cells
 * would else decide.
 *
 * Range: the 2nd to the 98th percentile of the finite values. If these are equal, minimum to
 * maximum; if these are too, one unit around. Most of an image is often nothing: where half of the
 * weight lies within a 50th of the full range around one value, the percentiles are those of the
 * rest, and the range goes on to that value. Background: the value at the middle of the fullest of
 * 256 bins of that range, if at least a tenth of the weight lies within a 50th of the range around
 * it: a free stream, an untouched solid. Else the low end. Opacity: 0 up to a 20th of the way from
 * the background to the farther end of the range, then rising to 1 there with the square of the
 * distance, so that the background is clear and extremes stand out. Colour: if the background lies
 * in the middle half of the range, Moreland's cool-warm diverging map with its neutral colour at
 * the background; else a perceptually uniform sequential map (plasma). Unit distance: with L the
 * side of the cube that has the diagonal of the mesh, and the mean opacity over the volume, L times
 * that mean, within [L / 100, L]: a ray through all of the mesh then has an optical depth near 1.
 * This is also the rule for presets, which don't say a unit distance. It is not the rule for images
 * and rectilinear grids: GetMeanSpacing() is theirs.
 */
#ifndef tetmarch_DefaultTransferFunction_h
#define tetmarch_DefaultTransferFunction_h

#include "Samples.h"
#include "TransferFunctions.h"

#include <array>
#include <optional>
#include <vector>

namespace tetmarch
{

struct ValueStatistics
{
  std::array<double, 2> Range{ { 0.0, 1.0 } }; // low < high
  double Background = 0.0;
};

enum class DataKind
{
  MESH,
  IMAGE // rectilinear grids, too
};

/// If range is given it replaces the percentiles.
ValueStatistics ComputeStatistics(std::vector<Sample> samples,
  const std::optional<std::array<double, 2>>& range = std::nullopt, DataKind kind = DataKind::MESH);

TransferFunctions MakeDefaultTransferFunctions(const ValueStatistics& statistics);

/// The length is the mesh's diagonal.
double ChooseUnitDistance(
  const std::vector<Sample>& samples, vtkPiecewiseFunction* opacity, double diagonal);

} // namespace tetmarch

#endif
