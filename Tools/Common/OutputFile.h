// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Files that the programs write.
 */
#ifndef tetmarch_OutputFile_h
#define tetmarch_OutputFile_h

#include <mutex>
#include <string>
#include <string_view>

namespace tetmarch
{

/**
 * A file that gets its name when it is complete. Until Keep() its bytes are in a temporary file in
 * the same folder, and a file that already has the name stays as it is. The temporary file is
 * removed by the destructor, and if SIGHUP, SIGINT or SIGTERM ends the program. One file at a time:
 * the constructor waits until another file is done.
 *
 * Each function throws Failure, which names the file and the reason.
 */
class OutputFile
{
public:
  /// A symbolic link stays one: the file that it names is written.
  explicit OutputFile(const std::string& path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  void Write(std::string_view bytes);

  /// Gives the file its name, and the permissions of the file that had this name before.
  void Keep();

private:
  std::unique_lock<std::mutex> Lock;
  std::string Path;      // as the user wrote it
  std::string Target;    // without symbolic links
  std::string Temporary; // empty: there is none
  int Descriptor = -1;
};

/// The same at once.
void WriteFile(const std::string& path, std::string_view bytes);

/// Why no file can be written under this name: it is a device, its folder is missing, ... Empty if
/// nothing is known. Writes nothing.
std::string FindOutputProblem(const std::string& path);

} // namespace tetmarch

#endif
