// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Measurement.h"

#include "ChildProcess.h"
#include "Failure.h"

#include <cstdio>
#include <functional>
#include <memory>

namespace tetmarch::bench
{
namespace
{
// Getting ready and the first frame hold all the preprocessing.
constexpr double FirstLimitFactor = 5.0;

nlohmann::json receive(ChildProcess& child, double limitSeconds)
{
  nlohmann::json answer = nlohmann::json::parse(child.receive(limitSeconds));
  if (answer.contains("error"))
  {
    throw Failure(answer["error"].get<std::string>());
  }
  return answer;
}

nlohmann::json ask(ChildProcess& child, const std::string& command, double limitSeconds)
{
  child.send(command);
  return receive(child, limitSeconds);
}

/// One mapper's process, as long as it does what it is asked.
struct Contestant
{
  MapperRecord& Record;
  std::unique_ptr<ChildProcess> Process;

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
        stderr, "  %-10s %s\n", this->Record.Mapper.c_str(), this->Record.Failure.c_str());
    }
  }
};

void start(Contestant& contestant, const Options& options, DatasetRecord& record)
{
  contestant.Process = std::make_unique<ChildProcess>(
    workerArguments(options, { record.Dataset, contestant.Record.Mapper }));
  contestant.attempt("preparation", [&](ChildProcess& child)
    { record.Ready = receive(child, FirstLimitFactor * options.LimitSeconds); });
}

void drawFrame(Contestant& contestant, const Options& options, int frame)
{
  contestant.attempt("frame " + std::to_string(frame),
    [&](ChildProcess& child)
    {
      const double factor = frame == 0 ? FirstLimitFactor : 1.0;
      const nlohmann::json answer = ask(child, "frame", factor * options.LimitSeconds);
      const double seconds = answer.at("seconds");
      MapperRecord& record = contestant.Record;
      (frame == 0 ? record.FirstFrames : record.Frames).push_back(seconds);
      record.Covered.push_back(answer.at("covered"));
      std::fprintf(stderr, "  %-10s frame %d: %.4f s\n", record.Mapper.c_str(), frame, seconds);
    });
}

void finish(Contestant& contestant, const Options& options)
{
  contestant.attempt("figures", [&](ChildProcess& child)
    { contestant.Record.Figures = ask(child, "finish", options.LimitSeconds); });
}

void runRound(const Options& options, DatasetRecord& record)
{
  std::vector<Contestant> contestants;
  for (MapperRecord& mapper : record.Mappers)
  {
    // What took too long or crashed once isn't waited for again.
    if (mapper.Failure.empty())
    {
      contestants.push_back({ mapper, nullptr });
      start(contestants.back(), options, record);
    }
  }
  for (int frame = 0; frame <= options.Frames; ++frame)
  {
    for (Contestant& contestant : contestants)
    {
      drawFrame(contestant, options, frame);
    }
  }
  for (Contestant& contestant : contestants)
  {
    finish(contestant, options);
  }
}
} // namespace

DatasetRecord measureDataset(const Options& options, const std::string& dataset)
{
  DatasetRecord record;
  record.Dataset = dataset;
  for (const std::string& mapper : options.Mappers)
  {
    record.Mappers.push_back({});
    record.Mappers.back().Mapper = mapper;
  }
  for (int round = 1; round <= options.Rounds; ++round)
  {
    std::fprintf(stderr, "%s, round %d of %d\n", dataset.c_str(), round, options.Rounds);
    runRound(options, record);
  }
  return record;
}
} // namespace tetmarch::bench
