// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The rival that gives the mesh up: its scalars on an image, drawn by VTK's GPU ray caster
 */
#ifndef tetmarch_bench_ResampledVolume_h
#define tetmarch_bench_ResampledVolume_h

#include "Mappers.h"

namespace tetmarch::bench
{
/**
 * The scene resampled to size^3 points over its bounds, with samples that many times the least
 * spacing apart. Opacities are made such that extinctions are those of the scene (the structured
 * mappers have another law); what is outside of the mesh is masked away. Throws Failure if nothing
 * is inside. The image is kept in the scene's CacheFolder with the time that it took.
 */
PreparedVolume makeResampledVolume(const Scene& scene, int size, double sampleDistance);
} // namespace tetmarch::bench

#endif
