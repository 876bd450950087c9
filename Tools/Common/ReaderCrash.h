// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Some readers of VTK crash on damaged files, which nothing can know before. The program then ends
 * with a message that names the file.
 */
#ifndef tetmarch_ReaderCrash_h
#define tetmarch_ReaderCrash_h

#include <string>

namespace tetmarch
{

/// As long as it lives the file is being read; one file at a time.
class FileBeingRead
{
public:
  explicit FileBeingRead(const std::string& path);
  FileBeingRead(const FileBeingRead&) = delete;
  FileBeingRead& operator=(const FileBeingRead&) = delete;
  ~FileBeingRead();
};

/// From now on a crash while a file is being read ends the program with an error and status 1.
void TellCrashesOfReaders();

} // namespace tetmarch

#endif
