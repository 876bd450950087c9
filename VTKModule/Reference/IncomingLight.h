// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Light that comes to a point through the volume.
#ifndef TetMarchReferenceIncomingLight_h
#define TetMarchReferenceIncomingLight_h

#include "Reference/GlslLanguage.h"

namespace tetmarch
{

/** Where lights, gradients and the transmittance towards the lights are evaluated. */
enum class LightAt
{
  Vertices, // transmittance at vertices or nodes, the rest at faces: as in pictures
  Faces,    // all of it where a ray crosses a face: near pictures with shadows along rays
  Points    // at as many points of each interval as it takes: the ground truth
};

/** The transmittance from a point of the normalised frame towards ambient light, then towards up to
 * three lights. */
template <typename Real>
class IncomingLight
{
public:
  virtual ~IncomingLight() = default;
  virtual glsl::Vec4<Real> at(glsl::Vec3<Real> point) const = 0;
};

} // namespace tetmarch

#endif
