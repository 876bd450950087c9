// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StandardOutput.h"

#include "Failure.h"
#include "ProgressBar.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

namespace tetmarch
{

void PrintText(std::string_view text)
{
  ProgressBar::Clear();
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
  {
    throw Failure(std::string("cannot write to standard output: ") + std::strerror(errno));
  }
}

} // namespace tetmarch
