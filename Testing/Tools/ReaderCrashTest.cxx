// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReaderCrash.h"

#include <csignal>
#include <cstdlib>
#include <gtest/gtest.h>
#include <string>

namespace
{
// Takes more of the stack than there is, for a depth that is large.
int Descend(int depth)
{
  volatile char taken[65536];
  taken[0] = static_cast<char>(depth);
  return depth == 0 ? 0 : Descend(depth - 1) + taken[0];
}

void CrashWhileReading(void (*crash)())
{
  tetmarch::TellCrashesOfReaders();
  const tetmarch::FileBeingRead reading("folder/a.vtu");
  crash();
}
} // namespace

TEST(ReaderCrash, IsToldAndEndsTheProgram)
{
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto ended = ::testing::ExitedWithCode(1);
  const std::string text = "^tetmarch-render: error: cannot read 'folder/a.vtu': VTK's reader "
                           "crashed, so the file is damaged\n$";
  EXPECT_EXIT(CrashWhileReading([] { std::raise(SIGSEGV); }), ended, text);
  EXPECT_EXIT(CrashWhileReading([] { std::abort(); }), ended, text);
  EXPECT_EXIT(CrashWhileReading([] { std::exit(0); }), ended, text);
  EXPECT_EXIT(CrashWhileReading([] { std::exit(Descend(1 << 20)); }), ended, text);
}

TEST(ReaderCrash, IsNoneWhenNothingIsRead)
{
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
    {
      tetmarch::TellCrashesOfReaders();
      {
        const tetmarch::FileBeingRead reading("a.vtu");
      }
      std::raise(SIGSEGV);
    },
    ::testing::KilledBySignal(SIGSEGV), "");
}
