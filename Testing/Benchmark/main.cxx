// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Failure.h"
#include "Measurement.h"
#include "Report.h"
#include "Statistics.h"
#include "Worker.h"

#include <cstdio>
#include <filesystem>

#include <unistd.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::bench;

std::vector<Subject> subjectsOf(const Options& options)
{
  std::vector<Subject> subjects;
  for (const std::string& dataset : options.Datasets)
  {
    if (options.Kind == "accuracy" && !isPresent(dataset, options.Folders))
    {
      std::fprintf(stderr, "%s is left out: it is not in %s\n", dataset.c_str(),
        options.Folders.Others.c_str());
      continue;
    }
    for (const std::string& functions : options.Functions)
    {
      subjects.push_back({ dataset, functions });
    }
  }
  return subjects;
}

/// Gone, with all in it, when this is.
class TemporaryFolder
{
public:
  TemporaryFolder()
    : Path(std::filesystem::temp_directory_path() / ("tetmarch-bench-" + std::to_string(getpid())))
  {
    std::filesystem::create_directories(this->Path);
  }
  ~TemporaryFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(this->Path, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string path() const { return this->Path.string(); }

private:
  std::filesystem::path Path;
};

void run(Options options)
{
  const TemporaryFolder temporary;
  if (options.CacheFolder.empty())
  {
    options.CacheFolder = temporary.path();
  }
  std::filesystem::create_directories(options.CacheFolder);
  std::vector<DatasetRecord> records;
  for (const Subject& subject : subjectsOf(options))
  {
    records.push_back(measureDataset(options, subject));
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
