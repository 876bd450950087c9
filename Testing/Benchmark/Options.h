// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The command line of tetmarch-bench
 */
#ifndef tetmarch_bench_Options_h
#define tetmarch_bench_Options_h

#include "Scene.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace tetmarch::bench
{
/// What one worker process measures.
struct Pair
{
  Subject Shown;
  std::string Mapper;
};

struct Options
{
  bool Help = false;
  std::string Kind = "speed"; // or "accuracy", ...: see presets in Options.cxx
  std::array<int, 2> Size = { { 512, 512 } };
  int Rounds = 2; // each with new processes
  int Frames = 5; // per round and mapper, after the first
  double LimitSeconds = 60.0;
  double EnoughSeconds = 1e9; // no more frames of a mapper in a round that took so long together
  bool Errors = false;        // measure them, too
  int Stride = 4;             // of images: errors are those of every so manieth pixel and row
  std::vector<std::string> Datasets = { "lattice162k", "lattice1.3m", "lattice6m", "golfball",
    "golfball-slab", "golfball-wake", "cheese", "wheelset", "crushed-can" };
  std::vector<std::string> Functions = { OwnFunctions };
  std::vector<std::string> Mappers = { "tetmarch", "projected", "bunyk" };
  std::vector<std::string> Effects; // empty: all
  std::string Against; // another tetmarch-bench, drawn by turns with this one; empty: none
  DataFolders Folders;
  std::string CacheFolder; // of workers, for what several make
  std::string JsonFile;
  std::string MarkdownFile;
  std::string GpuReportFile;  // empty: none
  std::optional<Pair> Worker; // set in the processes that the benchmark starts
};

/// The Kind of the benchmark of images.
extern const std::string StructuredKind;

/// Throws UsageError. Names of datasets, functions and mappers are checked.
Options parseOptions(const std::vector<std::string>& arguments);

std::string helpText();

/// The command line of a worker, without the name of the program.
std::vector<std::string> workerArguments(const Options& options, const Pair& pair);
} // namespace tetmarch::bench

#endif
