// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Machine.h"

#include <ctime>
#include <fstream>

#include <sched.h>
#include <unistd.h>

namespace tetmarch::bench
{
std::string currentDate()
{
  const std::time_t now = std::time(nullptr);
  char text[32];
  std::strftime(text, sizeof(text), "%Y-%m-%dT%H:%MZ", std::gmtime(&now));
  return text;
}

std::string cpuModel()
{
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
  {
    const auto colon = line.find(": ");
    if (line.compare(0, 10, "model name") == 0 && colon != std::string::npos)
    {
      return line.substr(colon + 2);
    }
  }
  return "unknown CPU";
}

int hardwareThreads()
{
  cpu_set_t set;
  return sched_getaffinity(0, sizeof(set), &set) == 0 ? CPU_COUNT(&set) : 1;
}

std::int64_t memoryBytes()
{
  return static_cast<std::int64_t>(sysconf(_SC_PHYS_PAGES)) * sysconf(_SC_PAGESIZE);
}
} // namespace tetmarch::bench
