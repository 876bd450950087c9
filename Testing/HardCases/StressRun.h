// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Very many rays through all hard cases, in parallel, kept in a file and resumed from it
 */
#ifndef tetmarch_testing_StressRun_h
#define tetmarch_testing_StressRun_h

#include "HardCase.h"
#include "MarchCheck.h"

#include <functional>
#include <string>
#include <vector>

namespace tetmarch::testing
{
struct StressRow
{
  const HardCase* Case = nullptr;
  std::int64_t Tetrahedra = 0;
  unsigned NextChunk = 0; ///< those before are marched; chunk numbers are seeds
  double Seconds = 0.0;   ///< of all threads together
  RayTotals Totals;
};

struct StressOptions
{
  std::int64_t Rays = 1000000000;   ///< over all cases, those of earlier runs included
  double Seconds = 1e9;             ///< this run ends after that long, to be resumed later
  std::int64_t LeastRays = 1000000; ///< of each case, before cheap ones get more
  std::string File;                 ///< JSON to resume from and to write; empty: none
  std::string Only;                 ///< the name of one case; empty: all
};

/// Marches until the options are met; tell gets a line of progress every few seconds. Throws
/// std::runtime_error if the file is of another run.
std::vector<StressRow> runStress(
  const StressOptions& options, const std::function<void(const std::string&)>& tell);

/// A Markdown table, a row a case, and a sum.
std::string stressTable(const std::vector<StressRow>& rows);
} // namespace tetmarch::testing

#endif
