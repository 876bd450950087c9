// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Random lists of visits, exchanged and merged, against sorting everything in one place: to the
// last bit.
#include "ThreadGroup.h"

#include "Processes/SentVisits.h"
#include "Processes/VisitExchange.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

constexpr float Opaque = 1.0f / 255.0f;

float share(std::mt19937& random) { return static_cast<float>(random() >> 8) / 16777216.0f; }

/** A picture of which each pixel has visits, each by some process. */
struct Scene
{
  int Width, Height, Processes;
  std::vector<std::vector<std::pair<int, Visit>>> Pixels; // of each, front to back

  Scene(int width, int height, int processes, unsigned int seed)
    : Width(width)
    , Height(height)
    , Processes(processes)
    , Pixels(static_cast<std::size_t>(width) * height)
  {
    std::mt19937 random(seed);
    for (auto& pixel : this->Pixels)
    {
      // A third of them are empty, and some have many.
      const unsigned int many = random() % 3 == 0 ? 0 : random() % (random() % 10 == 0 ? 60 : 5);
      float depth = -1;
      for (unsigned int i = 0; i < many; ++i)
      {
        Visit visit;
        visit.Begin = depth + (random() % 4 == 0 ? 0.1f * share(random) : 0.0f);
        visit.End = depth = visit.Begin + 0.01f + 0.1f * share(random);
        const float transmittance = share(random);
        visit.Gathered = { { share(random) * (1 - transmittance),
          share(random) * (1 - transmittance), share(random) * (1 - transmittance),
          transmittance } };
        visit.Error = 0.001f * share(random);
        pixel.emplace_back(
          static_cast<int>(random() % static_cast<unsigned int>(processes)), visit);
      }
    }
  }

  VisitLists listsOf(int process) const
  {
    VisitLists lists(this->Width, this->Height);
    for (std::size_t i = 0; i < this->Pixels.size(); ++i)
    {
      for (const auto& [by, visit] : this->Pixels[i])
      {
        if (by == process)
        {
          lists.add(static_cast<std::uint32_t>(i), visit);
        }
      }
    }
    lists.finish();
    return lists;
  }
};

// All visits of a pixel, in one place.
MergedPixel expected(const std::vector<std::pair<int, Visit>>& pixel, MergeRule rule)
{
  MergedPixel merged = emptyPixel(rule);
  auto& sum = merged.Gathered;
  for (const auto& [by, visit] : pixel)
  {
    if (rule == MergeRule::Greatest)
    {
      sum[0] = std::max(sum[0], visit.Gathered[0]);
      sum[1] = std::max(sum[1], visit.Gathered[1]);
    }
    else if (rule == MergeRule::Sum)
    {
      sum[0] += visit.Gathered[0];
      sum[1] += visit.Gathered[1];
    }
    else if (sum[3] >= Opaque)
    {
      for (int k = 0; k < 3; ++k)
      {
        sum[k] += sum[3] * visit.Gathered[k];
      }
      merged.Error += sum[3] * visit.Error;
      sum[3] *= visit.Gathered[3];
      merged.Error += sum[3] < Opaque ? sum[3] : 0; // whatever lies behind
    }
  }
  return merged;
}

TEST(VisitExchange, GivesWhatSortingInOnePlaceGives)
{
  for (const MergeRule rule : { MergeRule::Over, MergeRule::Greatest, MergeRule::Sum })
  {
    for (const int processes : { 1, 2, 3, 5, 8, 16 })
    {
      const Scene scene(37, 23, processes, static_cast<unsigned int>(processes));
      runTogether(processes,
        [&](Group& group)
        {
          ExchangeFigures figures;
          VisitExchange exchange(group, scene.Width, scene.Height, rule, Opaque, figures);
          exchange.add(scene.listsOf(group.rank()));
          const MergedPicture picture = exchange.spread();
          ASSERT_EQ(picture.Width, scene.Width);
          ASSERT_EQ(picture.Height, scene.Height);
          float worst = 0;
          for (std::size_t i = 0; i < scene.Pixels.size(); ++i)
          {
            const MergedPixel pixel = expected(scene.Pixels[i], rule);
            for (int k = 0; k < 4; ++k)
            {
              ASSERT_EQ(picture.Gathered[4 * i + k], pixel.Gathered[k]) << "pixel " << i;
            }
            worst = std::max(worst, pixel.Error);
          }
          EXPECT_EQ(picture.WorstError, worst);
        });
    }
  }
}

// Processes that march turn by turn leave out what the others have told to be hidden, and get the
// same picture.
TEST(VisitExchange, WhatIsHiddenNeedNotBeAdded)
{
  for (const int processes : { 2, 3, 8 })
  {
    const Scene scene(37, 23, processes, static_cast<unsigned int>(processes));
    runTogether(processes,
      [&](Group& group)
      {
        const VisitLists all = scene.listsOf(group.rank());
        ExchangeFigures figures;
        const auto begin = [&]
        { return VisitExchange(group, 37, 23, MergeRule::Over, Opaque, figures); };
        VisitExchange atOnce = begin();
        atOnce.add(all);
        const MergedPicture expected = atOnce.spread();
        ASSERT_FALSE(expected.Hidden.empty());

        VisitExchange inTurns = begin();
        HiddenDepths hidden(all.width() * all.height(), NothingHidden);
        std::size_t added = 0;
        for (std::uint32_t turn = 0; turn < 60; ++turn) // as many as a pixel has visits
        {
          VisitLists lists(all.width(), all.height());
          for (std::uint32_t pixel = 0; pixel < hidden.size(); ++pixel)
          {
            const Visit* visit = all.begin(pixel) + turn;
            if (turn < all.count(pixel) && visit->Begin <= hidden[pixel])
            {
              lists.add(pixel, *visit);
              ++added;
            }
          }
          lists.finish();
          inTurns.add(lists);
          hidden = inTurns.tellHidden();
        }
        EXPECT_LT(added, all.size());
        const MergedPicture picture = inTurns.spread();
        EXPECT_EQ(picture.Gathered, expected.Gathered);
        EXPECT_EQ(picture.WorstError, expected.WorstError);
        for (std::size_t pixel = 0; pixel < hidden.size(); ++pixel)
        {
          // Rows without hidden visits are not told at the end.
          EXPECT_TRUE(
            expected.Hidden[pixel] == hidden[pixel] || expected.Hidden[pixel] == NothingHidden);
        }
      });
  }
}

// 20,000 pixels of 65,535 visits each would take 40 GB.
TEST(VisitExchange, CountsThatLieTakeNoMemory)
{
  constexpr std::uint32_t width = 20000;
  const PixelSpan span{ 0, width };
  const std::vector<std::uint16_t> counts(width, 0xffff);
  Packer packer;
  packer.add(&span, 1);
  Unpacker withoutCounts(packer.Packed);
  EXPECT_THROW(takeRow(withoutCounts, width), GroupFailure);
  packer.add(counts.data(), counts.size());
  Unpacker withoutVisits(packer.Packed);
  EXPECT_THROW(takeRow(withoutVisits, width), GroupFailure);
}

TEST(VisitExchange, SmallPicturesAndProcessesWithoutVisits)
{
  for (const int height : { 1, 2, 3 })
  {
    runTogether(8,
      [&](Group& group)
      {
        VisitLists lists(1, height);
        const Visit visit{ 0, 1, { { 0.5f, 0.25f, 0.125f, 0.5f } }, 0 };
        if (group.rank() == 5)
        {
          lists.add(0, visit);
        }
        lists.finish();
        ExchangeFigures figures;
        VisitExchange exchange(group, 1, height, MergeRule::Over, Opaque, figures);
        exchange.add(lists);
        const MergedPicture picture = exchange.spread();
        ASSERT_EQ(picture.Gathered.size(), static_cast<std::size_t>(4 * height));
        EXPECT_EQ(picture.Gathered[0], 0.5f);
        EXPECT_EQ(picture.Gathered[3], 0.5f);
        for (int y = 1; y < height; ++y)
        {
          EXPECT_EQ(picture.Gathered[4 * y], 0.0f);
          EXPECT_EQ(picture.Gathered[4 * y + 3], 1.0f);
        }
      });
  }
}

TEST(VisitExchange, RowsWithoutVisitsCostEightBytes)
{
  VisitLists lists(1000, 10);
  const Visit visit{ 0, 1, { { 0.5f, 0.25f, 0.125f, 0.5f } }, 0 };
  lists.add(3 * 1000 + 500, visit);
  lists.add(3 * 1000 + 502, visit);
  lists.finish();
  // Of row 3 three counts and two visits.
  EXPECT_EQ(packVisits(lists, 1, 2).size(), 5 * 8 + 3 * 2 + 2 * sizeof(Visit));
  EXPECT_EQ(packVisits(lists, 0, 2).size(), 5u * 8);
}

TEST(VisitExchange, VisitsThatBeginAtOneDepthAreInOrderOfTheirEnds)
{
  // An exit and an entry by the same face may differ by a rounding. By their colors the last two
  // would be the other way round.
  std::vector<Visit> visits{ { 0.5f, 0.75f, { { 0, 0, 0.5f, 0.5f } }, 0 },
    { 0.25f, 0.5f, { { 0.5f, 0, 0, 0.5f } }, 0 }, { 0.5f, 0.5f, { { 0, 0.25f, 0, 0.75f } }, 0 } };
  const MergedPixel merged = mergeVisits(visits, MergeRule::Over, 0);
  EXPECT_EQ(merged.Gathered[0], 0.5f);
  EXPECT_EQ(merged.Gathered[1], 0.5f * 0.25f);
  EXPECT_EQ(merged.Gathered[2], 0.5f * 0.75f * 0.5f);
  EXPECT_EQ(merged.Gathered[3], 0.5f * 0.75f * 0.5f);
}

} // namespace
