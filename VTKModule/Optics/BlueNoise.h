// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Offsets of pixels that turn the bands of a coarse sampling into fine grain.
#ifndef TetMarchOpticsBlueNoise_h
#define TetMarchOpticsBlueNoise_h

#include <vector>

namespace tetmarch
{

constexpr int BlueNoiseSide = 64;

/**
 * BlueNoiseSide^2 numbers in rows, (rank + 0.5) / BlueNoiseSide^2 with each rank once, to tile the
 * picture with. They are evenly distributed, and neighbours differ much, also across the border of
 * the tile. Made by void and cluster (R. Ulichney, The void-and-cluster method for dither array
 * generation, 1993) on the first call, and always the same.
 */
const std::vector<float>& blueNoiseTile();

/** Of a pixel, counted from 0. */
inline float blueNoiseAt(int column, int row)
{
  return blueNoiseTile()[column % BlueNoiseSide + BlueNoiseSide * (row % BlueNoiseSide)];
}

} // namespace tetmarch

#endif
