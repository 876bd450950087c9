// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Times and errors of the mappers of images, by turns in one window
 */
#ifndef tetmarch_bench_StructuredMeasurement_h
#define tetmarch_bench_StructuredMeasurement_h

#include "Measurement.h"

namespace tetmarch::bench
{
struct StructuredRecord
{
  Subject Shown;
  std::array<int, 3> Dimensions = { { 0, 0, 0 } }; // points
  std::string ScalarType;                          // as stored
  nlohmann::json Environment;
  double ReferenceSeconds = 0.0;
  std::vector<MapperRecord> Mappers; // a first frame only of who has a mapper of its own
};

/**
 * Draws a frame of each mapper by turns, `Frames` times, into a framebuffer of floats; each turn
 * has another view. The picture of the first is compared with the ground truth in every
 * `Stride`-th pixel of every `Stride`-th row. Tells on standard error how it goes.
 */
StructuredRecord measureStructured(const Options& options, const Subject& subject);
} // namespace tetmarch::bench

#endif
