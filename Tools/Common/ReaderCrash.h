// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Some readers of VTK crash on damaged files, which nothing can know before. The program then ends
 * with a message that names the file.
 */
#ifndef tetmarch_ReaderCrash_h
#define tetmarch_ReaderCrash_h

#include "Failure.h"

#include <new>
#include <stdexcept>
#include <string>

namespace tetmarch
{

/// As long as it lives the file is being read. Of several at a time the last one is named.
class FileBeingRead
{
public:
  explicit FileBeingRead(const std::string& path);
  FileBeingRead(const FileBeingRead&) = delete;
  FileBeingRead& operator=(const FileBeingRead&) = delete;
  ~FileBeingRead();
};

/// What the work of a reader returns. Throws Failure where it takes more memory than there is.
template <typename Work>
auto WhileReading(const std::string& path, const Work& work)
{
  const FileBeingRead reading(path);
  const std::string error =
    "cannot read '" + path + "': its sizes ask for more memory than there is";
  try
  {
    return work();
  }
  catch (const std::bad_alloc&)
  {
    throw Failure(error);
  }
  catch (const std::length_error&)
  {
    throw Failure(error);
  }
}

/// From now on a crash while a file is being read ends the program with an error and status 1.
void TellCrashesOfReaders();

} // namespace tetmarch

#endif
