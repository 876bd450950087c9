// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Measurement.h"

#include "ChildProcess.h"
#include "WorkerAnswers.h"

#include <cstdio>
#include <functional>
#include <memory>

namespace tetmarch::bench
{
namespace
{
// Getting ready and the first frame hold all the preprocessing.
constexpr double FirstLimitFactor = 5.0;
// The reference is made by the CPU, with no regard to time.
constexpr double ReferenceLimitSeconds = 1800.0;

/// One mapper's process, as long as it does what it is asked.
struct Contestant
{
  MapperRecord& Record;
  std::unique_ptr<ChildProcess> Process;
  double Seconds = 0.0; // of its frames but the first

  void attempt(const std::string& what, const std::function<void(ChildProcess&)>& step)
  {
    if (!this->Process)
    {
      return;
    }
    try
    {
      step(*this->Process);
    }
    catch (const std::exception& error)
    {
      this->Process.reset();
      this->Record.Failure = what + ": " + error.what();
      std::fprintf(
        stderr, "  %-20s %s\n", this->Record.Mapper.c_str(), this->Record.Failure.c_str());
    }
  }
};

void start(Contestant& contestant, const Options& options, DatasetRecord& record)
{
  const bool other = contestant.Record.Mapper == AgainstMapper;
  contestant.Process = std::make_unique<ChildProcess>(
    workerArguments(options, { record.Shown, other ? "tetmarch" : contestant.Record.Mapper }),
    other ? options.Against : std::string());
  contestant.attempt("preparation", [&](ChildProcess& child)
    { record.Ready = receiveAnswer(child, FirstLimitFactor * options.LimitSeconds); });
}

void drawFrame(Contestant& contestant, const Options& options, int frame)
{
  contestant.attempt("frame " + std::to_string(frame),
    [&](ChildProcess& child)
    {
      const double factor = frame == 0 ? FirstLimitFactor : 1.0;
      const nlohmann::json answer = askWorker(child, "frame", factor * options.LimitSeconds);
      const double seconds = answer.at("seconds");
      MapperRecord& record = contestant.Record;
      (frame == 0 ? record.FirstFrames : record.Frames).push_back(seconds);
      contestant.Seconds += frame == 0 ? 0.0 : seconds;
      record.Covered.push_back(answer.at("covered"));
      std::fprintf(stderr, "  %-20s frame %d: %.4f s\n", record.Mapper.c_str(), frame, seconds);
    });
}

void askForFigures(Contestant& contestant, const Options& options)
{
  contestant.attempt("figures", [&](ChildProcess& child)
    { contestant.Record.Figures = askWorker(child, "figures", options.LimitSeconds); });
}

void askForErrors(Contestant& contestant, const Options& options, const std::string& file)
{
  contestant.attempt("errors",
    [&](ChildProcess& child)
    {
      contestant.Record.Errors =
        askWorker(child, "errors " + file, FirstLimitFactor * options.LimitSeconds);
      std::fprintf(stderr, "  %-20s errors: %s\n", contestant.Record.Mapper.c_str(),
        contestant.Record.Errors.dump().c_str());
    });
}

/// By a process of its own, which may be large.
void makeReference(const Options& options, DatasetRecord& record, const std::string& file)
{
  try
  {
    ChildProcess child(workerArguments(options, { record.Shown, "tetmarch" }));
    receiveAnswer(child, FirstLimitFactor * options.LimitSeconds);
    record.ReferenceSeconds =
      askWorker(child, "reference " + file, ReferenceLimitSeconds).at("seconds").get<double>();
    std::fprintf(stderr, "  reference: %.1f s\n", record.ReferenceSeconds);
  }
  catch (const std::exception& error)
  {
    record.ReferenceFailure = error.what();
    std::fprintf(stderr, "  reference: %s\n", error.what());
  }
}

/// `reference`: the file of the true picture if errors are to be measured; else empty.
void runRound(const Options& options, DatasetRecord& record, const std::string& reference)
{
  std::vector<Contestant> contestants;
  for (MapperRecord& mapper : record.Mappers)
  {
    // What took too long or crashed once isn't waited for again.
    if (mapper.Failure.empty())
    {
      contestants.push_back({ mapper, nullptr, 0.0 });
      start(contestants.back(), options, record);
    }
  }
  for (int frame = 0; frame <= options.Frames; ++frame)
  {
    for (Contestant& contestant : contestants)
    {
      if (frame <= 1 || contestant.Seconds < options.EnoughSeconds)
      {
        drawFrame(contestant, options, frame);
      }
    }
  }
  for (Contestant& contestant : contestants)
  {
    askForFigures(contestant, options);
    if (!reference.empty())
    {
      askForErrors(contestant, options, reference);
    }
  }
}
} // namespace

const std::string AgainstMapper = "against";

DatasetRecord measureDataset(const Options& options, const Subject& subject)
{
  DatasetRecord record;
  record.Shown = subject;
  for (const std::string& mapper : options.Mappers)
  {
    record.Mappers.push_back({});
    record.Mappers.back().Mapper = mapper;
  }
  if (!options.Against.empty())
  {
    record.Mappers.push_back({});
    record.Mappers.back().Mapper = AgainstMapper;
  }
  std::fprintf(stderr, "%s, %s\n", subject.Dataset.c_str(), subject.Functions.c_str());
  const std::string reference = options.CacheFolder + "/reference";
  if (options.Errors)
  {
    makeReference(options, record, reference);
  }
  for (int round = 1; round <= options.Rounds; ++round)
  {
    std::fprintf(stderr, " round %d of %d\n", round, options.Rounds);
    const bool compares = options.Errors && round == 1 && record.ReferenceFailure.empty();
    runRound(options, record, compares ? reference : "");
  }
  return record;
}
} // namespace tetmarch::bench
