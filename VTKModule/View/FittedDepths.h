// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Clip coordinates whose depths span only the volume.
#ifndef TetMarchViewFittedDepths_h
#define TetMarchViewFittedDepths_h

#include <array>

namespace tetmarch
{

struct VolumeFrame;
struct View;

/** Maximum difference between row[3] and the product of points in the volume's bounding box with a
 * row of a matrix. */
double reachOf(const double* row, const VolumeFrame& frame);

/**
 * view.NormalizedToClip with other depths: -1..1 spans the volume, not the camera's clipping range.
 * The order of depths is kept. If the eye is in the volume, they begin behind it, at a thousandth
 * of the farthest depth.
 */
std::array<double, 16> fittedDepths(const View& view, const VolumeFrame& frame);

} // namespace tetmarch

#endif
