// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Depths for rasterising the mesh alone.
#ifndef TetMarchRaysFittedDepths_h
#define TetMarchRaysFittedDepths_h

#include <array>

namespace tetmarch
{

struct VolumeFrame;
struct View;

/**
 * view.NormalizedToClip with other depths: -1..1 spans the mesh instead of the camera's clipping
 * range, however wide that is. What is nearer stays nearer. The mesh must lie behind the near
 * plane.
 */
std::array<double, 16> fittedDepths(const View& view, const VolumeFrame& frame);

} // namespace tetmarch

#endif
