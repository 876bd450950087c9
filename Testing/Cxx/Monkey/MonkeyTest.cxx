// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A monkey changes a scene at random. After each change there is a frame, without an error but
// those that are due; and now and then the picture is that of a mapper that knows nothing of the
// past.
//
// TETMARCH_MONKEY_SEED, _STEPS and _EVERY (steps between two comparisons) in the environment take
// the place of the numbers below, to hunt with or to repeat what was found.
#include "Monkey.h"
#include "../Benchmark/Memory.h"
#include "GLObjects.h"

#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <cstdlib>
#include <gtest/gtest.h>
#include <iostream>
#include <malloc.h>
#include <string>
#include <vector>

namespace
{
using namespace tetmarch::testing;

int numberOf(const char* variable, int otherwise)
{
  const char* value = std::getenv(variable);
  return value ? std::atoi(value) : otherwise;
}

// Collects the errors and warnings of VTK itself.
class Complaints : public vtkOutputWindow
{
public:
  static Complaints* New();
  vtkTypeMacro(Complaints, vtkOutputWindow);
  void DisplayText(const char* text) override { this->Texts += text; }
  std::string Texts;
};
vtkStandardNewMacro(Complaints);

class MonkeyTest : public testing::Test
{
protected:
  MonkeyTest() { vtkOutputWindow::SetInstance(this->Heard); }
  ~MonkeyTest() override { vtkOutputWindow::SetInstance(nullptr); }

  vtkNew<Complaints> Heard;
};

TEST_F(MonkeyTest, AThousandChanges)
{
  const int steps = numberOf("TETMARCH_MONKEY_STEPS", 1000);
  const int every = numberOf("TETMARCH_MONKEY_EVERY", 10);
  Monkey monkey(static_cast<unsigned>(numberOf("TETMARCH_MONKEY_SEED", 1)), steps);
  monkey.Live.show(monkey.State);
  while (monkey.Done < steps)
  {
    monkey.step();
    if (monkey.Done % every == 0)
    {
      monkey.compareWithFresh(monkey.Reference);
    }
    EXPECT_EQ(this->Heard->Texts, "");
    ASSERT_FALSE(HasFailure()) << monkey.story();
  }
  monkey.compareWithFresh(makeWindow());
  EXPECT_FALSE(HasFailure()) << monkey.story();
}

struct Footprint
{
  std::array<int, 5> Objects;
  int Shaders;
  std::int64_t Resident;
};

Footprint footprintOf(Monkey& monkey)
{
  monkey.beginAgain();
  monkey.Live.Mapper->ReleaseGraphicsResources(monkey.Live.Window);
  malloc_trim(0);
  return { countGLObjects(), countShaders(), tetmarch::bench::residentBytes() };
}

// Has Mesa's llvmpipe draw without threads in the windows to come. With threads, it keeps up to
// 64 lists of what to draw, and each of them the textures that it drew last, even if they are
// deleted, until chance uses it again: megabytes that come and go.
class NoThreads
{
public:
  NoThreads() { setenv(Variable, "0", 1); }
  ~NoThreads()
  {
    if (this->WasSet)
    {
      setenv(Variable, this->Before.c_str(), 1);
    }
    else
    {
      unsetenv(Variable);
    }
  }
  NoThreads(const NoThreads&) = delete;
  NoThreads& operator=(const NoThreads&) = delete;

private:
  static constexpr const char* Variable = "LP_NUM_THREADS";
  const bool WasSet = std::getenv(Variable);
  const std::string Before = WasSet ? std::getenv(Variable) : "";
};

// Rounds of the same changes: after the first ones all shaders and pools are there. The speed of
// the machine must not choose the level of a frame, which would be another shader in a later round.
TEST_F(MonkeyTest, RoundsLeaveNothing)
{
  constexpr int Rounds = 16;
  constexpr int Changes = 100;
  // Mesa's pool for uploads takes a second MiB in the fourth round or the fifth; none in 35 more.
  constexpr int LastOfPools = 5;
  constexpr std::int64_t MostGrowth = 256 << 10; // found: 52 KiB at most
  const NoThreads noThreads;
  Monkey monkey(7, Changes, timeless);
  std::vector<Footprint> after;
  for (int round = 0; round < Rounds; ++round)
  {
    monkey.beginAgain();
    while (monkey.Done < Changes)
    {
      monkey.step();
      ASSERT_FALSE(HasFailure()) << monkey.story();
    }
    after.push_back(footprintOf(monkey));
    std::cout << "[ MEASURED ] round " << round << ": " << after.back().Resident / 1024
              << " KiB resident, " << after.back().Shaders << " shaders\n";
  }
  EXPECT_EQ(after[Rounds - 1].Objects, after[1].Objects);
  EXPECT_EQ(after[Rounds - 1].Shaders, after[1].Shaders);
  EXPECT_LE(after[Rounds - 1].Resident - after[LastOfPools].Resident, MostGrowth);
  EXPECT_EQ(this->Heard->Texts, "");
}
} // namespace
