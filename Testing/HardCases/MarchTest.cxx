// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A million rays and more through the hard cases, and their pictures, by the CPU twin.
#include "MarchCheck.h"
#include "PictureCheck.h"
#include "StressRun.h"

#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch::testing;

TEST(HardCases, RaysAreWhatTheyMustBe)
{
  StressOptions options;
  options.Rays = 2000000;
  options.LeastRays = 4096;
  const auto rows = runStress(options, [](const std::string& line) { std::cout << line << '\n'; });
  std::int64_t rays = 0;
  for (const StressRow& row : rows)
  {
    EXPECT_EQ(row.Totals.failures(), 0) << row.Case->Name << ": " << row.Totals.FirstFailure;
    EXPECT_GT(row.Totals.Met, row.Totals.Rays / 8) << row.Case->Name;
    rays += row.Totals.Rays;
  }
  EXPECT_GE(rays, options.Rays);
  if (::testing::Test::HasFailure())
  {
    std::cout << stressTable(rows);
  }
}

class HardPicture : public ::testing::TestWithParam<std::string>
{
};

TEST_P(HardPicture, OfTheTwinIsRight)
{
  const HardCase& hard = *findHardCase(GetParam());
  for (const HardView& view : viewsOf(hard))
  {
    PictureCheck check(hard, view, HardPictureSize);
    tetmarch::MarchCounters counters;
    const Image picture = check.twin(counters);
    const PictureResult result = check.compare(picture, counters, DrawnBy::Twin);
    EXPECT_EQ(result.failures(), 0)
      << view.Name << ": " << result.NotFinite << " not finite, " << result.OutOfBound
      << " out of bound, " << counters.Lost << " lost, " << counters.Guarded << " guarded, "
      << counters.Refused << " refused, worst error " << result.WorstError;
    if (const HardCase* other = findHardCase(hard.SamePictureAs))
    {
      PictureCheck same(*other, viewOfSameName(*other, view), HardPictureSize);
      const Difference difference = compare(picture, same.twin(counters));
      EXPECT_LE(difference.Max, 1.0 / 255.0) << view.Name << ": " << difference.text();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Case, HardPicture, ::testing::ValuesIn(hardCaseNames()),
  [](const ::testing::TestParamInfo<std::string>& tested) { return identifierOf(tested.param); });
} // namespace
