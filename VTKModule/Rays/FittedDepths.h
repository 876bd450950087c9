// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Clip coordinates whose depths span the volume alone.
#ifndef TetMarchRaysFittedDepths_h
#define TetMarchRaysFittedDepths_h

#include <array>

namespace tetmarch
{

struct VolumeFrame;
struct View;

/** How much the product of points with a row of a matrix differs from row[3] over the volume's
 * bounding box, at most. */
double reachOf(const double* row, const VolumeFrame& frame);

/**
 * view.NormalizedToClip with other depths: -1..1 spans the volume instead of the camera's clipping
 * range, however wide that is. The order of depths stays. The volume must lie behind the near
 * plane.
 */
std::array<double, 16> fittedDepths(const View& view, const VolumeFrame& frame);

} // namespace tetmarch

#endif
