// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ScarceMemory.h"

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <link.h>
#include <new>

namespace
{
constexpr std::size_t Plenty = std::numeric_limits<std::size_t>::max();
constexpr int Never = -1;

std::atomic<std::size_t> Bytes{ Plenty };
std::atomic<bool> Once{ false };
std::atomic<int> Successes{ 0 }; // before the one that fails; Never: no more
std::atomic<int> Failures{ 0 };
std::atomic<int> Tries{ 0 };

/// Addresses of the code whose allocations may fail.
struct Code
{
  std::uintptr_t Begin = 0;
  std::uintptr_t End = std::numeric_limits<std::uintptr_t>::max();
  bool has(const void* address) const
  {
    const auto at = reinterpret_cast<std::uintptr_t>(address);
    return at >= this->Begin && at < this->End;
  }
};
Code Callers; // changes while Bytes is Plenty

/// The addresses of the loaded library, or of the program, that has the address.
Code codeAround(const void* address)
{
  struct Search
  {
    const void* Address;
    Code Found;
  } search{ address, { 0, 0 } };
  dl_iterate_phdr(
    [](dl_phdr_info* info, std::size_t, void* data)
    {
      auto* searched = static_cast<Search*>(data);
      for (int i = 0; i < info->dlpi_phnum; ++i)
      {
        const std::uintptr_t begin = info->dlpi_addr + info->dlpi_phdr[i].p_vaddr;
        const Code part{ begin, begin + info->dlpi_phdr[i].p_memsz };
        if (info->dlpi_phdr[i].p_type == PT_LOAD && part.has(searched->Address))
        {
          searched->Found = part;
        }
      }
      return 0;
    },
    &search);
  return search.Found;
}

bool fails(std::size_t bytes, const void* caller)
{
  if (bytes < Bytes || !Callers.has(caller))
  {
    return false;
  }
  ++Tries;
  if (Once && (Successes == Never || Successes.fetch_sub(1) != 0))
  {
    return false;
  }
  ++Failures;
  return true;
}

void* allocate(std::size_t bytes, const void* caller) noexcept
{
  return fails(bytes, caller) ? nullptr : std::malloc(bytes > 0 ? bytes : 1);
}
} // namespace

void* operator new(std::size_t bytes, const std::nothrow_t& /*unused*/) noexcept
{
  return allocate(bytes, __builtin_return_address(0));
}
void* operator new(std::size_t bytes)
{
  void* memory = allocate(bytes, __builtin_return_address(0));
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
  Tries = 0;
  Successes = successes;
  Once = true;
  Bytes = bytes;
}
ScarceMemory::ScarceMemory(std::size_t bytes, int successes, const void* library)
  : ScarceMemory(Plenty, successes)
{
  Callers = codeAround(library);
  Bytes = bytes;
}
ScarceMemory::~ScarceMemory()
{
  Bytes = Plenty;
  Callers = {};
}
int ScarceMemory::failures() { return Failures; }
int ScarceMemory::tries() { return Tries; }
} // namespace tetmarch::testing
