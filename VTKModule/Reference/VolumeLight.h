// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Light that comes through the volume, on the CPU: kept at vertices like on the GPU, or looked for
// by brute force.
#ifndef TetMarchReferenceVolumeLight_h
#define TetMarchReferenceVolumeLight_h

#include "Reference/LitKernel.h"

#include <memory>
#include <vector>

namespace tetmarch
{

struct ReferenceScene;

/** Four a vertex: ambient light, then that of up to three lights that cast shadows; 0..1. By the
 * rays of Shaders/light/vertex_light.glsl. */
template <typename Real>
std::vector<Real> lightAtVertices(const ReferenceScene& scene);

/** The same for any point. Rays come from the light, find their way into the mesh by its hierarchy,
 * and are marched as those of the picture are: what is tested by it shares the step through a
 * tetrahedron and the tables, and no more. */
template <typename Real>
std::unique_ptr<IncomingLight<Real>> exactLight(const ReferenceScene& scene);

} // namespace tetmarch

#endif
