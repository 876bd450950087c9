// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Monkey.h"

#include "GLObjects.h"
#include "MonkeyGrids.h"
#include "SameFaces.h"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <sstream>

namespace tetmarch::testing
{
namespace
{
constexpr int LastActions = 12; // the ones that a failure lists
constexpr int FirstVariants = 8;
constexpr int MostVariants = 40; // of the shader: a window builds each, which takes its time
constexpr int DeedsShare = 8;    // one in so many actions
constexpr int HeldShare = 4;     // one in so many comparisons

// The words of an error that the state calls for; empty if it doesn't call for this one.
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

// If two faces lie at the same depth, their numbers decide by which of them a ray enters. Numbers
// stay when points move, so a new mapper may choose the other face. Only views of faces show this.
void expectSameFaces(const Image& found, const Image& expected, int viewMode)
{
  constexpr std::size_t fewest = 100; // one pixel in a hundred may differ
  const std::size_t others = viewMode == vtkTetMarchVolumeMapper::VIEW_BOUNDARY_FACES
                               ? countOtherFaces(found, expected)
                               : compare(withSortedColors(found), withSortedColors(expected)).Over;
  EXPECT_LE(fewest * others, found.Rgba.size() / 4) << others << " pixels show other faces";
}

// The objects of the mapper. They are freed, so that all of them are made anew.
std::array<int, 5> heldBy(MonkeyScene& scene)
{
  scene.Window->MakeCurrent();
  std::array<int, 5> held = countGLObjects();
  scene.Mapper->ReleaseGraphicsResources(scene.Window);
  const std::array<int, 5> left = countGLObjects();
  std::transform(held.begin(), held.end(), left.begin(), held.begin(), std::minus<>());
  return held;
}
} // namespace

Monkey::Monkey(unsigned seed, int steps, Shown shown)
  : Seed(seed)
  , Steps(steps)
  , Random(seed)
  , ShownOf(shown)
{
}

void Monkey::show(bool inPlace)
{
  this->Live.show(this->ShownOf ? this->ShownOf(this->State) : this->State, inPlace);
}

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
  this->show();
  this->Live.render();
}

// The number of variants that may be built grows with the steps, so that new ones come up to the
// end.
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
    this->show();
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
    this->show(this->Random.chance(2));
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
  MonkeyState rest = atRest(this->State);
  if (rest.showsBoundary())
  {
    rest.Translucent = 0; // nothing is mixed with the colours of faces
  }
  this->Live.show(rest);
  const Image found = this->Live.render();
  this->checkFrame();
  MonkeyScene fresh(window);
  fresh.show(rest);
  const Image expected = fresh.render();
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  if (rest.showsBoundary())
  {
    expectSameFaces(found, expected, rest.ViewMode);
  }
  else
  {
    const Difference difference = compare(found, expected);
    EXPECT_EQ(difference.Max, 0.0) << difference.text();
  }
  this->compareHeld(fresh, rest);
  expectDue(fresh.Watch.Errors, rest);
  if (!fresh.Watch.Errors.empty())
  {
    EXPECT_EQ(causeOf(fresh.Watch.Errors.back(), rest), causeOf(this->LastError, rest));
  }
  this->Live.Window->MakeCurrent();
  this->show();
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
} // namespace tetmarch::testing
