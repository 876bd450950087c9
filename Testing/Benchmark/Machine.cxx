// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Machine.h"

#include <algorithm>
#include <ctime>
#include <fstream>

#include <sched.h>
#include <sys/utsname.h>
#include <unistd.h>

namespace tetmarch::bench
{
namespace
{
/// What follows the beginning on the first line of a file that has it; else the other text.
std::string restOfLine(const char* file, const std::string& begin, const std::string& otherwise)
{
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);)
  {
    if (line.compare(0, begin.size(), begin) == 0)
    {
      return line.substr(begin.size());
    }
  }
  return otherwise;
}
} // namespace

std::string currentDate()
{
  const std::time_t now = std::time(nullptr);
  char text[32];
  std::strftime(text, sizeof(text), "%Y-%m-%dT%H:%MZ", std::gmtime(&now));
  return text;
}

std::string operatingSystem()
{
  std::string name = restOfLine("/etc/os-release", "PRETTY_NAME=", "unknown system");
  name.erase(std::remove(name.begin(), name.end(), '"'), name.end());
  utsname kernel{};
  uname(&kernel);
  return name + ", " + kernel.sysname + " " + kernel.release + ", " + kernel.machine;
}

std::string cpuModel() { return restOfLine("/proc/cpuinfo", "model name\t: ", "unknown CPU"); }

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
