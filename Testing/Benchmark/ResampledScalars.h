// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The scalars of a mesh on an image, made once for all mappers that draw it
 */
#ifndef tetmarch_bench_ResampledScalars_h
#define tetmarch_bench_ResampledScalars_h

#include "Scene.h"

#include "vtkImageData.h"
#include "vtkNew.h"

namespace tetmarch::bench
{
struct ResampledScalars
{
  vtkNew<vtkImageData> Image; // float
  vtkNew<vtkImageData> Mask;  // 255; 0 outside of the mesh
  bool HasOutside = false;
};

/**
 * By vtkResampleToImage over the bounds of the grid, size^3 points, or from the scene's
 * CacheFolder. Returns the seconds that the former took less those that this call did. Throws
 * Failure if there is nothing inside, or the folder can't be written to.
 */
double fetchOrResample(const Scene& scene, int size, ResampledScalars& result);
} // namespace tetmarch::bench

#endif
