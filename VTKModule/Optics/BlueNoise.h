// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Offsets of pixels that hide as fine grain what a coarse sampling would show as bands.
#ifndef TetMarchOpticsBlueNoise_h
#define TetMarchOpticsBlueNoise_h

#include <vector>

namespace tetmarch
{

constexpr int BlueNoiseSide = 64;

/**
 * BlueNoiseSide^2 numbers in rows, (rank + 0.5) / BlueNoiseSide^2 with each rank once, to be laid
 * side by side over the picture: they are distributed evenly, and neighbours, also those across the
 * tile's border, differ much. By void and cluster (R. Ulichney, The void-and-cluster method for
 * dither array generation, 1993). Always the same; made when first asked for.
 */
const std::vector<float>& blueNoiseTile();

} // namespace tetmarch

#endif
