// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The shown range of values of the data, and its background.
// Each cell is weighted by the area that it covers in a picture, volume^(2/3), with the volume of
// its bounding box, since meshes are finest at walls, where values are extreme, and these small
// cells would otherwise dominate.
//
// Range: the 2nd to the 98th percentile of the finite values. If these are equal, or differ by less
// than 1e-290, minimum to maximum; if these do, too, one unit around. Values beyond a quarter of
// the largest double are clamped to it. Images often consist mostly of air: if half of the weight
// lies within a 50th of the full range around one value, the percentiles are those of the rest, and
// the range is extended to that value. Background: the value at the middle of the fullest of 256
// bins of that range, if at least a tenth of the weight lies within a 50th of the range around it:
// a free stream, an untouched solid. Else the low end, and so if all values are equal.
#ifndef TetMarchFirstPictureValueStatistics_h
#define TetMarchFirstPictureValueStatistics_h

#include "FirstPicture/Samples.h"

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

// If range is given it replaces the percentiles. lattice: of images and rectilinear grids.
ValueStatistics computeStatistics(
  std::vector<Sample> samples, const std::optional<std::array<double, 2>>& range, bool lattice);

} // namespace tetmarch

#endif
