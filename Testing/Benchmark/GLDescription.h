// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What a driver of the GL says of itself, and what our code found out about it
 */
#ifndef tetmarch_bench_GLDescription_h
#define tetmarch_bench_GLDescription_h

#include <nlohmann/json_fwd.hpp>

class vtkRenderWindow;

namespace tetmarch::bench
{
/// Versions, limits and extensions; null for a limit that this GL doesn't have. The window was
/// rendered.
nlohmann::json describeGL(vtkRenderWindow* window);

/// What our shaders are told of the driver, and by which the mapper chooses their variants.
nlohmann::json probeDriver(vtkRenderWindow* window);
} // namespace tetmarch::bench

#endif
