// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What of a picture is hidden: where rays end, where they wait, and what is expected of the next.
#include "Processes/ExpectedDepths.h"
#include "Processes/NextEntries.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;

constexpr float Opaque = 1.0f / 255.0f;

Visit visitOf(float begin, float transmittance)
{
  return { begin, begin + 0.25f, { { 0.5f, 0, 0, transmittance } }, 0 };
}

TEST(HiddenDepths, APixelIsHiddenFromTheVisitThatMakesItOpaque)
{
  std::vector<Visit> visits{ visitOf(0.5f, 0.01f), visitOf(0.25f, 0.1f), visitOf(0.75f, 0.5f),
    visitOf(1.0f, 0.5f) };
  const MergedPixel merged = mergeVisits(visits, MergeRule::Over, Opaque);
  EXPECT_EQ(merged.HiddenFrom, 0.5f);
  EXPECT_EQ(merged.HiddenVisits, 2u);
  EXPECT_FLOAT_EQ(merged.Error, 0.001f);

  // Whatever lies behind: the same, and the same bound.
  visits = { visitOf(0.25f, 0.1f), visitOf(0.5f, 0.01f) };
  const MergedPixel without = mergeVisits(visits, MergeRule::Over, Opaque);
  EXPECT_EQ(without.Gathered, merged.Gathered);
  EXPECT_EQ(without.HiddenFrom, 0.5f);
  EXPECT_EQ(without.HiddenVisits, 0u);
  EXPECT_EQ(without.Error, merged.Error);

  visits = { visitOf(0.25f, 0.1f), visitOf(0.5f, 0.1f) };
  EXPECT_EQ(mergeVisits(visits, MergeRule::Over, Opaque).HiddenFrom, NothingHidden);
  visits = { visitOf(0.25f, 0), visitOf(0.5f, 0) };
  EXPECT_EQ(mergeVisits(visits, MergeRule::Greatest, Opaque).HiddenFrom, NothingHidden);
}

TEST(HiddenDepths, RaysGoOnBeforeWhatIsHidden)
{
  NextEntries entries(4, 3);
  EXPECT_TRUE(entries.any());
  EXPECT_EQ(entries.boxOfSeen({}).Pixels, 12u); // all may enter anywhere
  for (std::uint32_t pixel = 0; pixel < 12; ++pixel)
  {
    entries.end(pixel);
  }
  EXPECT_FALSE(entries.any());
  EXPECT_EQ(entries.boxOfSeen({}).Pixels, 0u);

  entries.set(1, 0.5f);  // (1, 0)
  entries.set(7, 0.5f);  // (3, 1)
  entries.set(10, 0.5f); // (2, 2)
  HiddenDepths hidden(12, NothingHidden);
  hidden[7] = 0.25f;
  hidden[10] = 0.5f; // what begins there is seen, what begins behind is not
  const PixelBox box = entries.boxOfSeen(hidden);
  EXPECT_EQ(box.Pixels, 2u);
  EXPECT_EQ(box.X, 1);
  EXPECT_EQ(box.Y, 0);
  EXPECT_EQ(box.Width, 2);
  EXPECT_EQ(box.Height, 3);
  EXPECT_EQ(entries.endHidden(hidden), 1u);
  EXPECT_EQ(entries.endHidden(hidden), 0u);
  EXPECT_EQ(entries.boxOfSeen({}).Pixels, 2u);
  EXPECT_FALSE(NextEntries().any()); // a process without a piece
}

// What of three rows of five pixels is expected behind a pixel at (2, 1) with so many hidden visits
// among a hundred.
HiddenDepths expectedAfter(int hiddenVisits, int width = 5)
{
  ExpectedDepths expected;
  expected.begin(5, 3);
  EXPECT_TRUE(expected.ofRows(0, 3).empty()); // nothing is known
  HiddenDepths depths(15, 0.25f);
  depths[7] = 0.5f;
  expected.learn(0, HiddenDepths(15, 0.75f));
  expected.learn(0, depths);
  VisitLists lists(5, 3);
  for (int i = 0; i < 100; ++i)
  {
    lists.add(7, visitOf(i < hiddenVisits ? 0.625f : 0.5f, 1));
  }
  lists.finish();
  std::vector<VisitLists> turns;
  turns.push_back(lists);
  expected.count(0, turns, 0);
  expected.begin(width, 3);
  return expected.ofRows(0, 3);
}

TEST(HiddenDepths, TheLastPictureTellsWhatToExpect)
{
  const HiddenDepths expected = expectedAfter(50);
  ASSERT_EQ(expected.size(), 15u);
  for (int y = 0; y < 3; ++y)
  {
    for (int x = 0; x < 5; ++x)
    {
      // The pixels around may show tomorrow what is at (2, 1) today.
      EXPECT_EQ(expected[5 * y + x], x >= 1 && x <= 3 ? 0.5f : 0.25f) << x << ' ' << y;
    }
  }
}

TEST(HiddenDepths, LittleThatIsHiddenIsNotWaitedFor)
{
  EXPECT_TRUE(expectedAfter(5).empty());
  EXPECT_FALSE(expectedAfter(20).empty());
  EXPECT_TRUE(expectedAfter(50, 3).empty()); // another size
}

TEST(HiddenDepths, BandsAreExpectedByThemselves)
{
  ExpectedDepths expected;
  expected.begin(1, 8);
  expected.learn(0, HiddenDepths(4, 0.25f));
  expected.learn(4, HiddenDepths(4, 0.5f));
  expected.count(0, {}, 10);
  expected.begin(1, 8);
  EXPECT_EQ(expected.ofRows(0, 3), HiddenDepths(3, 0.25f));
  EXPECT_EQ(expected.ofRows(5, 8), HiddenDepths(3, 0.5f));
  expected.begin(1, 8); // and forgotten if nothing is hidden any more
  EXPECT_TRUE(expected.ofRows(0, 8).empty());
}

} // namespace
