// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EffectReport.h"
#include "Failure.h"
#include "GpuReport.h"
#include "Measurement.h"
#include "OutputFile.h"
#include "Report.h"
#include "StructuredReport.h"
#include "StructuredVolumes.h"
#include "Worker.h"

#include <cstdio>
#include <filesystem>
#include <optional>

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
    const bool isMissing = options.Kind == StructuredKind
                             ? !isStructuredPresent(dataset, options.Folders)
                             : !isPresent(dataset, options.Folders);
    if (isMissing)
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

void write(const Options& options, const nlohmann::ordered_json& report, const std::string& text)
{
  if (!options.JsonFile.empty())
  {
    WriteFile(options.JsonFile, report.dump(2) + "\n");
  }
  if (!options.MarkdownFile.empty())
  {
    WriteFile(options.MarkdownFile, text);
  }
}

/// Files are written after each dataset, so that a run which is cut short leaves what it has.
template <typename Record>
void measureAll(const Options& options, std::optional<GpuReport>& gpu,
  Record (*measure)(const Options&, const Subject&),
  nlohmann::ordered_json (*describe)(const Options&, const std::vector<Record>&),
  std::string (*makeText)(const nlohmann::ordered_json&))
{
  std::vector<Record> records;
  for (const Subject& subject : subjectsOf(options))
  {
    records.push_back(measure(options, subject));
    const auto report = describe(options, records);
    write(options, report, makeText(report));
    if (gpu)
    {
      gpu->setBenchmark(report);
    }
  }
  std::fputs(makeText(describe(options, records)).c_str(), stdout);
}

void run(Options options)
{
  const TemporaryFolder temporary;
  if (options.CacheFolder.empty())
  {
    options.CacheFolder = temporary.path();
  }
  std::filesystem::create_directories(options.CacheFolder);
  std::optional<GpuReport> gpu;
  if (!options.GpuReportFile.empty())
  {
    gpu.emplace(options);
    gpu->measure();
  }
  if (options.Kind == "effects")
  {
    measureAll(options, gpu, measureEffects, makeEffectReport, makeEffectMarkdown);
  }
  else if (options.Kind == StructuredKind)
  {
    measureAll(options, gpu, measureStructured, makeStructuredReport, makeStructuredMarkdown);
  }
  else
  {
    measureAll(options, gpu, measureDataset, makeReport, makeMarkdown);
  }
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
