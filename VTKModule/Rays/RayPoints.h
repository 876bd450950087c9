// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A point of each pixel's ray that float can hold, for rays that no rasterised face leads to.
#ifndef TetMarchRaysRayPoints_h
#define TetMarchRaysRayPoints_h

#include <array>

namespace tetmarch
{

struct VolumeFrame;
struct View;

/**
 * A row-major matrix that takes (x, y, 0, 1), clip coordinates, to a point of the ray of (x, y) in
 * the normalised frame. Where the near plane cuts the mesh, it is the point on the near plane. Else
 * it lies before the eye and, if the ray meets the mesh, within two mesh radii of its centre: rays
 * keep their digits however far away the eye is, and however askew the volume's matrix.
 */
std::array<double, 16> rayPoints(const View& view, const VolumeFrame& frame);

} // namespace tetmarch

#endif
