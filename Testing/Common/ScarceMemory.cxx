// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ScarceMemory.h"

#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>

namespace
{
constexpr std::size_t Plenty = std::numeric_limits<std::size_t>::max();
constexpr int Never = -1;

std::atomic<std::size_t> Bytes{ Plenty };
std::atomic<bool> Once{ false };
std::atomic<int> Successes{ 0 }; // before the one that fails; Never: no more
std::atomic<int> Failures{ 0 };

bool fails(std::size_t bytes)
{
  if (bytes < Bytes || (Once && (Successes == Never || Successes.fetch_sub(1) != 0)))
  {
    return false;
  }
  ++Failures;
  return true;
}
} // namespace

void* operator new(std::size_t bytes, const std::nothrow_t& /*unused*/) noexcept
{
  return fails(bytes) ? nullptr : std::malloc(bytes > 0 ? bytes : 1);
}
void* operator new(std::size_t bytes)
{
  void* memory = operator new(bytes, std::nothrow);
  if (!memory)
  {
    throw std::bad_alloc();
  }
  return memory;
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace tetmarch::testing
{
ScarceMemory::ScarceMemory(std::size_t bytes)
{
  Failures = 0;
  Once = false;
  Bytes = bytes;
}
ScarceMemory::ScarceMemory(std::size_t bytes, int successes)
{
  Failures = 0;
  Successes = successes;
  Once = true;
  Bytes = bytes;
}
ScarceMemory::~ScarceMemory() { Bytes = Plenty; }
int ScarceMemory::failures() { return Failures; }
} // namespace tetmarch::testing
