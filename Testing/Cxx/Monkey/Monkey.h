// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Changes a scene at random, and checks each frame
 */
#ifndef tetmarch_testing_Monkey_h
#define tetmarch_testing_Monkey_h

#include "MonkeyActions.h"

#include <deque>
#include <set>
#include <string>

namespace tetmarch::testing
{
/// Changes what a scene shows, step by step, all of it told by the seed.
class Monkey
{
public:
  /// `shown` tells what a scene is shown of a state; without it, all.
  using Shown = MonkeyState (*)(const MonkeyState& state);

  Monkey(unsigned seed, int steps, Shown shown = nullptr);

  /// A change or a deed, and a frame: without an error but those that the state calls for.
  void step();
  /// The same picture, the same bytes and objects on the GPU, and the same error as of a mapper
  /// that is new in that window.
  void compareWithFresh(vtkRenderWindow* window);
  /// The same steps once more: with all shaders there, nothing grows.
  void beginAgain();
  /// How to repeat what was done, and the last of it.
  std::string story() const;

  const unsigned Seed;
  const int Steps;
  int Done = 0;
  MonkeyState State;
  MonkeyRandom Random;
  vtkSmartPointer<vtkRenderWindow> Reference = makeWindow(); // whose shaders stay
  MonkeyScene Live{ makeWindow() };

private:
  void show(bool inPlace = false);
  bool mayBuild(const MonkeyState& state);
  void checkFrame();
  void compareHeld(MonkeyScene& fresh, const MonkeyState& state);

  const Shown ShownOf;
  bool WasInside = false;
  int Comparisons = 0;
  std::set<std::string> Built;
  std::deque<std::string> Last;
  std::string LastError; // that the live mapper told
};
} // namespace tetmarch::testing

#endif
