// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Every effect on one dataset, by turns and each beside the base frame
 */
#ifndef tetmarch_bench_EffectMeasurement_h
#define tetmarch_bench_EffectMeasurement_h

#include "Effects.h"
#include "Options.h"

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

namespace tetmarch::bench
{
/// What one turn of one effect took, in seconds; see Drawing::drawEffect().
struct EffectSample
{
  double Base = 0.0;  // a frame of nothing on, just before
  double First = 0.0; // the frame in which the effect was switched on
  double Frame = 0.0; // the one after it
  double Gradients = 0.0;
  double Light = 0.0; // at vertices
};

struct EffectRecord
{
  Effect Shown;
  std::map<int, EffectSample> Samples; // by turn; turns of all effects show the same views
  double BaseBytes = 0.0;              // on the GPU
  double Bytes = 0.0;
  double Covered = 0.0; // share of the window, last frame
  std::string Failure;  // why it was left out from some turn on; empty: it wasn't
};

struct EffectsRecord
{
  Subject Shown;
  nlohmann::json Ready; // what the last process said before its first frame
  std::vector<EffectRecord> Effects;
};

/// Tells on standard error how it goes.
EffectsRecord measureEffects(const Options& options, const Subject& subject);
} // namespace tetmarch::bench

#endif
