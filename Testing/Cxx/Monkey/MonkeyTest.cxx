// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A monkey changes a scene at random. After each change there is a frame, without an error but
// those that are due; and now and then the picture is that of a mapper that knows nothing of the
// past.
//
// TETMARCH_MONKEY_SEED, _STEPS and _EVERY (steps between two comparisons) in the environment take
// the place of the numbers below, to hunt with or to repeat what was found.
#include "../Benchmark/Memory.h"
#include "GLObjects.h"
#include "MonkeyActions.h"
#include "MonkeyGrids.h"

#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <algorithm>
#include <cstdlib>
#include <deque>
#include <gtest/gtest.h>
#include <iostream>
#include <malloc.h>
#include <set>
#include <sstream>
#include <string>

namespace
{
using namespace tetmarch::testing;

int numberOf(const char* variable, int otherwise)
{
  const char* value = std::getenv(variable);
  return value ? std::atoi(value) : otherwise;
}

constexpr int LastActions = 12; // that a failure tells
constexpr int FirstVariants = 8;
constexpr int MostVariants = 40; // of the shader: a window builds each, which takes its time
constexpr int DeedsShare = 8;    // one in so many actions
constexpr int HeldShare = 4;     // one in so many comparisons

// What VTK complains of itself.
class Complaints : public vtkOutputWindow
{
public:
  static Complaints* New();
  vtkTypeMacro(Complaints, vtkOutputWindow);
  void DisplayText(const char* text) override { this->Texts += text; }
  std::string Texts;
};
vtkStandardNewMacro(Complaints);

class Monkey
{
public:
  Monkey(unsigned seed, int steps)
    : Seed(seed)
    , Steps(steps)
    , Random(seed)
  {
  }

  void step();
  /// Of the picture, of what is held on the GPU, and of what is complained of.
  void compareWithFresh(vtkRenderWindow* window);
  /// What it did, once more: with all shaders there, nothing grows.
  void beginAgain();
  std::string story() const;

  const unsigned Seed;
  const int Steps;
  int Done = 0;
  MonkeyState State;
  MonkeyRandom Random;
  vtkSmartPointer<vtkRenderWindow> Reference = makeWindow(); // whose shaders stay
  MonkeyScene Live{ makeWindow() };

private:
  bool mayBuild(const MonkeyState& state);
  void checkFrame();
  void compareHeld(MonkeyScene& fresh, const MonkeyState& state);

  bool WasInside = false;
  int Comparisons = 0;
  std::set<std::string> Built;
  std::deque<std::string> Last;
  std::string LastError; // that the live mapper told
};

std::string Monkey::story() const
{
  std::ostringstream text;
  text << "TETMARCH_MONKEY_SEED=" << this->Seed << " TETMARCH_MONKEY_STEPS=" << this->Steps
       << ", step " << this->Done << ", " << traitsOf(this->State.Dataset).Name << ", "
       << MonkeySizes[this->State.Size].Width << " x " << MonkeySizes[this->State.Size].Height
       << " pixels" << (this->State.SecondRenderer ? " of two renderers" : "")
       << (this->State.peels() ? ", peeled" : "") << ". The last actions:";
  for (const std::string& name : this->Last)
  {
    text << "\n  " << name;
  }
  return text.str();
}

void Monkey::beginAgain()
{
  this->Done = 0;
  this->State = {};
  this->Random = MonkeyRandom(this->Seed);
  this->Built.clear();
  this->Last.clear();
  this->Live.show(this->State);
  this->Live.render();
}

// The longer it goes, the more, so that something new comes up to the end.
bool Monkey::mayBuild(const MonkeyState& state)
{
  const std::string key = variantOf(state).defines();
  const std::size_t most =
    FirstVariants + (MostVariants - FirstVariants) * this->Done / this->Steps;
  if (this->Built.count(key) == 0 && this->Built.size() >= most)
  {
    return false;
  }
  this->Built.insert(key);
  return true;
}

void Monkey::step()
{
  ++this->Done;
  std::string name;
  if (!refusalsOf(this->State).empty() && this->Random.chance(2))
  {
    name = "all is mended";
    this->State = mended(this->State);
    this->Live.show(this->State);
  }
  else if (this->Random.chance(DeedsShare))
  {
    const MonkeyDeed& deed = this->Random.of(monkeyDeeds());
    name = deed.Name;
    this->Last.push_back(name);
    deed.Do(this->Live, this->Random);
    this->Last.pop_back();
  }
  else
  {
    MonkeyState next;
    do
    {
      const MonkeyChange& change = this->Random.of(monkeyChanges());
      next = this->State;
      change.Make(next, this->Random);
      name = change.Name;
    } while (!this->mayBuild(next));
    this->State = next;
    this->Live.show(this->State, this->Random.chance(2));
  }
  this->Last.push_back(name);
  if (this->Last.size() > LastActions)
  {
    this->Last.pop_front();
  }
  this->WasInside = this->WasInside || this->State.isInside();
  this->Live.render();
  this->checkFrame();
}

// Of an error, in words; empty if the state doesn't call for it.
std::string causeOf(const std::string& error, const MonkeyState& state)
{
  for (const std::string& words : refusalsOf(state))
  {
    if (error.find(words) != std::string::npos)
    {
      return words;
    }
  }
  return {};
}

void expectDue(const std::vector<std::string>& errors, const MonkeyState& state)
{
  for (const std::string& error : errors)
  {
    EXPECT_NE(causeOf(error, state), "") << error;
  }
}

void Monkey::checkFrame()
{
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  std::vector<std::string>& errors = this->Live.Watch.Errors;
  expectDue(errors, this->State);
  if (!errors.empty())
  {
    this->LastError = errors.back();
    errors.clear();
  }
}

void Monkey::compareWithFresh(vtkRenderWindow* window)
{
  const MonkeyState rest = atRest(this->State);
  this->Live.show(rest);
  const Image found = this->Live.render();
  this->checkFrame();
  MonkeyScene fresh(window);
  fresh.show(rest);
  const Image expected = fresh.render();
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  const Difference difference = compare(found, expected);
  EXPECT_EQ(difference.Max, 0.0) << difference.text();
  this->compareHeld(fresh, rest);
  expectDue(fresh.Watch.Errors, rest);
  if (!fresh.Watch.Errors.empty())
  {
    EXPECT_EQ(causeOf(fresh.Watch.Errors.back(), rest), causeOf(this->LastError, rest));
  }
  this->Live.Window->MakeCurrent();
  this->Live.show(this->State);
}

// Of the mapper. It frees it, so that it is all made anew.
std::array<int, 5> heldBy(MonkeyScene& scene)
{
  scene.Window->MakeCurrent();
  std::array<int, 5> held = countGLObjects();
  scene.Mapper->ReleaseGraphicsResources(scene.Window);
  const std::array<int, 5> left = countGLObjects();
  std::transform(held.begin(), held.end(), left.begin(), held.begin(), std::minus<>());
  return held;
}

void Monkey::compareHeld(MonkeyScene& fresh, const MonkeyState& state)
{
  if (!fresh.Watch.Errors.empty() || fresh.Mapper->GetGPUMemoryBytes() == 0)
  {
    return; // what isn't drawn now keeps what it had
  }
  const vtkTypeInt64 bytes = this->Live.Mapper->GetGPUMemoryBytes();
  if (this->WasInside && fresh.Mapper->GetGPUMemoryBytes() < bytes)
  {
    // The search tree that a camera in the mesh needs stays with the mesh.
    MonkeyState inside = state;
    inside.View = MonkeyState::Inside;
    fresh.show(inside);
    fresh.render();
    fresh.show(state);
    fresh.render();
  }
  EXPECT_EQ(bytes, fresh.Mapper->GetGPUMemoryBytes());
  if (++this->Comparisons % HeldShare == 0)
  {
    EXPECT_EQ(heldBy(this->Live), heldBy(fresh));
  }
}

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

// Rounds of the same changes: after the first ones all shaders and pools are there.
TEST_F(MonkeyTest, RoundsLeaveNothing)
{
  constexpr int Rounds = 16;
  constexpr int Changes = 100;
  // Mesa's pool for uploads takes a second MiB in the fourth round or the fifth; none in 35 more.
  constexpr int LastOfPools = 5;
  constexpr std::int64_t MostGrowth = 256 << 10; // found: 52 KiB at most
  const NoThreads noThreads;
  Monkey monkey(7, Changes);
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
