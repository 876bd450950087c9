// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EffectMeasurement.h"

#include "ChildProcess.h"
#include "WorkerAnswers.h"

#include <algorithm>
#include <cstdio>
#include <memory>

namespace tetmarch::bench
{
namespace
{
// Two frames, and preprocessing, shader compilation or light at vertices before them.
constexpr double TurnLimitFactor = 7.0;

/// One process that switches effects on and off.
class EffectWorker
{
public:
  EffectWorker(const Options& options, EffectsRecord& record)
    : Process(workerArguments(options, { record.Shown, "tetmarch" }))
    , LimitSeconds(TurnLimitFactor * options.LimitSeconds)
  {
    record.Ready = receiveAnswer(this->Process, this->LimitSeconds);
  }

  nlohmann::json draw(const std::string& effect, int view)
  {
    return askWorker(
      this->Process, "effect " + effect + " " + std::to_string(view), this->LimitSeconds);
  }

private:
  ChildProcess Process;
  double LimitSeconds;
};

void takeTurn(EffectWorker& worker, EffectRecord& record, int turn)
{
  // Anew each time: what slows the machine for a while slows both frames, and the stages of the
  // effect, of which nothing is kept where it is off, run again.
  const nlohmann::json base = worker.draw(NoEffect, turn);
  const nlohmann::json drawn = worker.draw(record.Shown.Name, turn);
  EffectSample sample;
  sample.Base = base.at("seconds");
  sample.First = drawn.at("first_seconds");
  sample.Frame = drawn.at("seconds");
  sample.Gradients = drawn.at("gradients_seconds");
  sample.Light = drawn.at("light_seconds");
  record.Samples[turn] = sample;
  record.BaseBytes = base.at("gpu_bytes");
  record.Bytes = drawn.at("gpu_bytes");
  record.Covered = drawn.at("covered");
  std::fprintf(stderr, "  %-20s turn %d: %.4f s, base %.4f s\n", record.Shown.Name.c_str(), turn,
    sample.Frame, sample.Base);
}

void runRound(const Options& options, EffectsRecord& record, int round)
{
  std::unique_ptr<EffectWorker> worker;
  std::vector<double> spent(record.Effects.size(), 0.0);
  for (int i = 0; i < options.Frames; ++i)
  {
    for (std::size_t j = 0; j < record.Effects.size(); ++j)
    {
      // There and back, so that a machine that gets slower or faster does so for all.
      const std::size_t at = i % 2 ? record.Effects.size() - 1 - j : j;
      EffectRecord& effect = record.Effects[at];
      if (!effect.Failure.empty() || spent[at] >= options.EnoughSeconds)
      {
        continue;
      }
      const int turn = round * options.Frames + i;
      try
      {
        if (!worker)
        {
          worker = std::make_unique<EffectWorker>(options, record);
        }
        takeTurn(*worker, effect, turn);
        spent[at] += effect.Samples[turn].Frame;
      }
      catch (const std::exception& error)
      {
        worker.reset();
        effect.Failure = "turn " + std::to_string(turn) + ": " + error.what();
        std::fprintf(stderr, "  %-20s %s\n", effect.Shown.Name.c_str(), effect.Failure.c_str());
      }
    }
  }
}
} // namespace

EffectsRecord measureEffects(const Options& options, const Subject& subject)
{
  EffectsRecord record;
  record.Shown = subject;
  for (const Effect& effect : effects())
  {
    const auto& wanted = options.Effects;
    if (wanted.empty() || std::find(wanted.begin(), wanted.end(), effect.Name) != wanted.end())
    {
      record.Effects.push_back({});
      record.Effects.back().Shown = effect;
    }
  }
  std::fprintf(stderr, "%s, %s\n", subject.Dataset.c_str(), subject.Functions.c_str());
  for (int round = 0; round < options.Rounds; ++round)
  {
    std::fprintf(stderr, " round %d of %d\n", round + 1, options.Rounds);
    runRound(options, record, round);
  }
  return record;
}
} // namespace tetmarch::bench
