// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The mappers that are compared, set up to draw the same picture
 */
#ifndef tetmarch_bench_Mappers_h
#define tetmarch_bench_Mappers_h

#include "Scene.h"

#include "vtkSmartPointer.h"
#include "vtkVolume.h"

#include <string>
#include <vector>

namespace tetmarch::bench
{
/// The PixelTolerance of the mappers whose names begin with "tetmarch-adaptive".
constexpr double AdaptiveTolerance = 4.0 / 255.0;

bool isMapper(const std::string& name);

struct PreparedVolume
{
  vtkSmartPointer<vtkVolume> Volume;
  /// What making it would have taken, had another process not done a part of it before, less what
  /// that part took here.
  double OwedSeconds = 0.0;
};

/// The scene by that mapper. What has to be done to the grid before is done here, or found in the
/// scene's CacheFolder.
PreparedVolume makeVolume(const std::string& name, const Scene& scene);
} // namespace tetmarch::bench

#endif
