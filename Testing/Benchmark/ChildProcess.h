// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Another process of this program, or one like it, that is asked line by line, and may crash
 * or hang
 */
#ifndef tetmarch_bench_ChildProcess_h
#define tetmarch_bench_ChildProcess_h

#include <string>
#include <vector>

#include <sys/types.h>

namespace tetmarch::bench
{
class ChildProcess
{
public:
  /// An empty `program` is this one. Throws Failure if no process can be started.
  explicit ChildProcess(const std::vector<std::string>& arguments, const std::string& program = {});
  /// Ends the process if it still runs.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  void send(const std::string& line);

  /// The next line of its standard output. Throws Failure if the process ended instead, or took
  /// longer than the given time; it runs no more then.
  std::string receive(double limitSeconds);

private:
  std::string waitForEnd();
  void end();

  pid_t Id = -1;
  int Input = -1;
  int Output = -1;
  std::string Received;
};
} // namespace tetmarch::bench

#endif
