// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Files that list other files as the time steps of a series: ParaView's .pvd, which is XML, and
 * .series, which is JSON.
 */
#ifndef tetmarch_FileSeries_h
#define tetmarch_FileSeries_h

#include <string>
#include <vector>

namespace tetmarch
{

/// One file; those of the same time step are parts of it.
struct SeriesPart
{
  std::string Path; // from the folder of the list, unless absolute
  std::string Name; // of the block that it becomes; may be empty
  int Number = 0;
};

struct SeriesStep
{
  double Time = 0.0;
  std::vector<SeriesPart> Parts; // by their numbers
};

struct FileSeries
{
  std::vector<SeriesStep> Steps; // by their times, at least one
  bool HasTimes = false;         // else all files are parts of the only step
};

/// By the ending of its name.
bool IsSeriesFile(const std::string& path);

/// Reads none of the files that are listed. Throws Failure that says what is wrong.
FileSeries ReadSeries(const std::string& path);

/// None if the list tells of no times.
std::vector<double> GetTimes(const FileSeries& series);

} // namespace tetmarch

#endif
