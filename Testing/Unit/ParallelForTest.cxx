// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Loops in threads call each part once, and what a part throws reaches the caller, with each back
// end of VTK.
#include "Parallel/ParallelFor.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <new>
#include <stdexcept>
#include <vector>

namespace
{
using namespace tetmarch;

class ParallelFor : public ::testing::TestWithParam<const char*>
{
protected:
  template <typename Work>
  static void withBackEnd(Work&& work)
  {
    vtkSMPTools::Config config;
    config.Backend = GetParam();
    vtkSMPTools::LocalScope(config,
      [&]
      {
        ASSERT_STREQ(vtkSMPTools::GetBackend(), GetParam());
        work();
      });
  }
};

TEST_P(ParallelFor, CallsEachPartOnce)
{
  withBackEnd(
    []
    {
      std::vector<int> calls(10000);
      parallelFor(10, 9990,
        [&](vtkIdType first, vtkIdType last)
        { std::for_each(&calls[first], &calls[last], [](int& count) { ++count; }); });
      EXPECT_EQ(std::count(calls.begin(), calls.end(), 1), 9980);
      EXPECT_EQ(calls[9] + calls[9990], 0);
    });
}

TEST_P(ParallelFor, ThrowsWhatAPartThrows)
{
  withBackEnd(
    []
    {
      for (const vtkIdType bad : { 0, 517, 999 })
      {
        const auto loop = [bad](vtkIdType first, vtkIdType last)
        {
          if (first <= bad && bad < last)
          {
            throw std::bad_alloc();
          }
        };
        EXPECT_THROW(parallelFor(0, 1000, 10, loop), std::bad_alloc) << bad;
      }
      EXPECT_THROW(
        parallelFor(0, 64, 1, [](vtkIdType, vtkIdType) { throw std::runtime_error("each"); }),
        std::runtime_error);
    });
}

INSTANTIATE_TEST_SUITE_P(BackEnds, ParallelFor, ::testing::Values("Sequential", "STDThread", "TBB"),
  [](const auto& backEnd) { return std::string(backEnd.param); });
} // namespace
