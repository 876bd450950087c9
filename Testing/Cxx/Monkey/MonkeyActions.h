// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What the monkey can do to a scene, each action with a name
 */
#ifndef tetmarch_testing_MonkeyActions_h
#define tetmarch_testing_MonkeyActions_h

#include "MonkeyScene.h"

#include <functional>
#include <random>
#include <vector>

namespace tetmarch::testing
{
/// From the raw output of the generator, the same on all platforms.
class MonkeyRandom
{
public:
  explicit MonkeyRandom(unsigned seed)
    : Generator(seed)
  {
  }
  /// 0 to count - 1.
  int below(int count) { return static_cast<int>(this->Generator() % unsigned(count)); }
  bool chance(int of) { return this->below(of) == 0; }
  /// 0 to 1.
  double share() { return this->below(1001) / 1000.0; }
  template <typename Value>
  Value of(const std::vector<Value>& values)
  {
    return values[this->below(static_cast<int>(values.size()))];
  }

private:
  std::mt19937 Generator;
};

/// Changes what is to be shown.
struct MonkeyChange
{
  const char* Name;
  std::function<void(MonkeyState& state, MonkeyRandom& random)> Make;
};
const std::vector<MonkeyChange>& monkeyChanges();

/// Does something to a scene that changes nothing of what is to be shown.
struct MonkeyDeed
{
  const char* Name;
  std::function<void(MonkeyScene& scene, MonkeyRandom& random)> Do;
};
const std::vector<MonkeyDeed>& monkeyDeeds();
} // namespace tetmarch::testing

#endif
