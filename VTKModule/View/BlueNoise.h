// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Offsets of samples per pixel that turn the banding of coarse sampling into noise.
#ifndef TetMarchViewBlueNoise_h
#define TetMarchViewBlueNoise_h

#include <vector>

namespace tetmarch
{

constexpr int BlueNoiseSide = 64;

/**
 * BlueNoiseSide^2 numbers in rows, (rank + 0.5) / BlueNoiseSide^2 with each rank once, a tile for
 * the picture. They are evenly distributed, and neighbours differ strongly, also across the border
 * of the tile. Computed by void and cluster (R. Ulichney, The void-and-cluster method for dither
 * array generation, 1993) on the first call; deterministic.
 */
const std::vector<float>& blueNoiseTile();

/** The number of a pixel, counted from 0. */
inline float blueNoiseAt(int column, int row)
{
  return blueNoiseTile()[column % BlueNoiseSide + BlueNoiseSide * (row % BlueNoiseSide)];
}

} // namespace tetmarch

#endif
