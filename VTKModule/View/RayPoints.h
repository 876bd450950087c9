// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A point on each pixel's ray that is representable in float.
#ifndef TetMarchViewRayPoints_h
#define TetMarchViewRayPoints_h

#include <array>

namespace tetmarch
{

struct VolumeFrame;
struct View;

/**
 * A row-major matrix that transforms clip coordinates (x, y, 0, 1) to a point on the ray of (x, y)
 * in the normalised frame. It lies before the eye and, if the ray meets the volume, within two
 * radii of its centre or, if the near plane cuts the volume, at its far end: so rays are precise
 * for any distance of the eye and any matrix of the volume.
 */
std::array<double, 16> rayPoints(const View& view, const VolumeFrame& frame);

} // namespace tetmarch

#endif
