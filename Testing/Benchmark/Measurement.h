// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Every mapper on one dataset, one frame each in turn, and what it is off by
 */
#ifndef tetmarch_bench_Measurement_h
#define tetmarch_bench_Measurement_h

#include "Options.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace tetmarch::bench
{
/// The mapper of the other build, if there is one.
extern const std::string AgainstMapper;

/// What the processes of one mapper answered in all rounds.
struct MapperRecord
{
  std::string Mapper;
  std::vector<double> FirstFrames; // seconds; one a round
  std::vector<double> Frames;      // the others
  std::vector<double> Covered;     // share of the window, every frame
  nlohmann::json Figures;          // at the end of the last round that had one
  nlohmann::json Errors;           // of the first view, if they were asked for
  std::string Failure;             // why it was left out from some frame on; empty: it wasn't
};

struct DatasetRecord
{
  Subject Shown;
  nlohmann::json Ready; // what the last process said before its first frame
  double ReferenceSeconds = 0.0;
  std::string ReferenceFailure; // why there are no errors
  std::vector<MapperRecord> Mappers;
};

/// Tells on standard error how it goes.
DatasetRecord measureDataset(const Options& options, const Subject& subject);
} // namespace tetmarch::bench

#endif
