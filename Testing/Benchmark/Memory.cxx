// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Memory.h"

#include <fstream>
#include <sstream>
#include <string>

namespace tetmarch::bench
{
namespace
{
/// Of proc(5)'s status file, where it counts in kB; 0 if there is no such line.
std::int64_t statusBytes(const std::string& name)
{
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
  {
    std::istringstream words(line);
    std::string label;
    std::int64_t kilobytes = 0;
    if (words >> label >> kilobytes && label == name + ":")
    {
      return 1024 * kilobytes;
    }
  }
  return 0;
}
} // namespace

std::int64_t residentBytes() { return statusBytes("VmRSS"); }

// Not getrusage(): its maximum begins with that of the process that forked this one.
std::int64_t peakResidentBytes() { return statusBytes("VmHWM"); }

void forgetPeak() { std::ofstream("/proc/self/clear_refs") << "5"; }
} // namespace tetmarch::bench
