// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The transmittance towards the lights, on the CPU: at the vertices like on the GPU, or from any
// point by brute force.
#ifndef TetMarchReferenceVolumeLight_h
#define TetMarchReferenceVolumeLight_h

#include "Reference/IncomingLight.h"

#include <memory>
#include <vector>

namespace tetmarch
{

struct ReferenceScene;

/** Four a vertex: ambient light, then that of up to three lights that cast shadows; 0..1. By the
 * rays of Shaders/light/vertex_light.glsl. */
template <typename Real>
std::vector<Real> lightAtVertices(const ReferenceScene& scene);

/** The same from any point. Rays start at the light, enter the mesh by its hierarchy, and are
 * marched as those of the picture are: they share with the light at vertices the step through a
 * tetrahedron and the tables, and no more. */
template <typename Real>
std::unique_ptr<IncomingLight<Real>> exactLight(const ReferenceScene& scene);

} // namespace tetmarch

#endif
