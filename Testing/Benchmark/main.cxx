// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Failure.h"
#include "Measurement.h"
#include "Report.h"
#include "Statistics.h"
#include "Worker.h"

#include <cstdio>

namespace
{
using namespace tetmarch;
using namespace tetmarch::bench;

void run(const Options& options)
{
  std::vector<DatasetRecord> records;
  for (const std::string& dataset : options.Datasets)
  {
    records.push_back(measureDataset(options, dataset));
    // Written after each dataset, so that a run which is cut short leaves what it has.
    const auto report = makeReport(options, records);
    if (!options.JsonFile.empty())
    {
      WriteText(options.JsonFile, report.dump(2) + "\n");
    }
    if (!options.MarkdownFile.empty())
    {
      WriteText(options.MarkdownFile, makeMarkdown(report));
    }
  }
  std::fputs(makeMarkdown(makeReport(options, records)).c_str(), stdout);
}
} // namespace

int main(int argc, char* argv[])
{
  try
  {
    const Options options = parseOptions({ argv + 1, argv + argc });
    if (options.Help)
    {
      std::fputs(helpText().c_str(), stdout);
      return 0;
    }
    if (options.Worker)
    {
      return runWorker(options);
    }
    run(options);
    return 0;
  }
  catch (const UsageError& error)
  {
    std::fprintf(stderr, "tetmarch-bench: %s (--help shows the options)\n", error.what());
    return 2;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "tetmarch-bench: %s\n", error.what());
    return 1;
  }
}
