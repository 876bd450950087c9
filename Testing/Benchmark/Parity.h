// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How far the GL's picture is from those that the CPU computes of the same frame
 */
#ifndef tetmarch_bench_Parity_h
#define tetmarch_bench_Parity_h

#include <nlohmann/json_fwd.hpp>

class vtkRenderWindow;
class vtkTetMarchVolumeMapper;
class vtkVolume;

namespace tetmarch::bench
{
/**
 * Draws the frame that is set up once more, with diagnostics. "ground_truth" has the differences
 * from the picture in double precision, "cpu" those of some of its rays from the march in float at
 * the frame's own accuracy: "max", "mean" (over channels: premultiplied r, g, b, and opacity; 0..1)
 * and "p999"; null if there are no pixels to compare. Pixels that are not finite are counted and
 * left out of these. Throws Failure if a picture can't be had.
 */
nlohmann::json measureParity(
  vtkRenderWindow* window, vtkTetMarchVolumeMapper* mapper, vtkVolume* volume);
} // namespace tetmarch::bench

#endif
