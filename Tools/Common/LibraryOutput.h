// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What a library prints by itself while it works.
 */
#ifndef tetmarch_LibraryOutput_h
#define tetmarch_LibraryOutput_h

#include <sstream>
#include <string>

namespace tetmarch
{

/// As long as it lives, it has what goes to std::cout and std::cerr.
class LibraryOutput
{
public:
  LibraryOutput();
  LibraryOutput(const LibraryOutput&) = delete;
  LibraryOutput& operator=(const LibraryOutput&) = delete;
  ~LibraryOutput();

  std::string GetFirstLine() const;

private:
  std::ostringstream Text;
  std::streambuf* Cout;
  std::streambuf* Cerr;
};

} // namespace tetmarch

#endif
