// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Parallel/HugePages.h"

#ifdef __linux__
#include <cstdint>

#include <sys/mman.h>
#endif

namespace tetmarch
{

void preferHugePages(void* begin, std::size_t bytes)
{
#ifdef __linux__
  constexpr std::uintptr_t smallPage = 4096;
  constexpr std::size_t hugePage = std::size_t(1) << 21;
  const auto from = (reinterpret_cast<std::uintptr_t>(begin) + smallPage - 1) & ~(smallPage - 1);
  const auto end = reinterpret_cast<std::uintptr_t>(begin) + bytes;
  if (bytes >= 2 * hugePage)
  {
    // A refusal changes nothing.
    madvise(reinterpret_cast<void*>(from), end - from, MADV_HUGEPAGE);
  }
#else
  (void)begin;
  (void)bytes;
#endif
}

} // namespace tetmarch
