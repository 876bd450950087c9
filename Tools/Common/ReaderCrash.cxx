// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReaderCrash.h"

#include "Messages.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <unistd.h>

namespace
{
// What the handler prints: it must take no memory, whose manager may be what is broken.
std::array<char, 8192> Text;
std::atomic<std::size_t> Length = 0; // 0: nothing is being read

/// Returns if no file is being read.
void EndIfReading()
{
  const std::size_t length = Length;
  if (length > 0)
  {
    const auto written = write(STDERR_FILENO, Text.data(), length);
    _exit(written < 0 ? 2 : 1);
  }
}

void EndBySignal(int signal)
{
  EndIfReading();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}
} // namespace

namespace tetmarch
{

FileBeingRead::FileBeingRead(const std::string& path)
{
  const std::string text = GetProgramName() + ": error: cannot read '" + path +
                           "': VTK's reader crashed, so the file is damaged\n";
  const std::size_t length = std::min(text.size(), Text.size());
  std::memcpy(Text.data(), text.data(), length);
  Length = length;
}

FileBeingRead::~FileBeingRead() { Length = 0; }

void TellCrashesOfReaders()
{
  std::atexit(EndIfReading);            // which the library below the CGNS reader does
  static std::array<char, 65536> stack; // of the handler, where that of the program is full
  stack_t other{};
  other.ss_sp = stack.data();
  other.ss_size = stack.size();
  sigaltstack(&other, nullptr);
  struct sigaction action = {};
  action.sa_handler = EndBySignal;
  action.sa_flags = SA_ONSTACK;
  for (const int signal : { SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT })
  {
    sigaction(signal, &action, nullptr);
  }
}

} // namespace tetmarch
