// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ChildProcess.h"

#include "Failure.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace tetmarch::bench
{
namespace
{
using Clock = std::chrono::steady_clock;

constexpr char ThisProgram[] = "/proc/self/exe";
constexpr int NotStarted = 127; // what a shell answers for a program that can't be run

struct Pipe
{
  int Ends[2] = { -1, -1 };

  Pipe()
  {
    if (pipe2(this->Ends, O_CLOEXEC) != 0)
    {
      throw Failure(std::string("no pipe: ") + std::strerror(errno));
    }
  }
};

std::string describeEnd(int status)
{
  if (WIFSIGNALED(status))
  {
    const int signal = WTERMSIG(status);
    return "crashed: signal " + std::to_string(signal) + ", " + strsignal(signal);
  }
  return "ended early with status " + std::to_string(WEXITSTATUS(status));
}
} // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& arguments, const std::string& program)
{
  // Writing to a process that has crashed shall fail, not end this one.
  std::signal(SIGPIPE, SIG_IGN);
  const char* path = program.empty() ? ThisProgram : program.c_str();
  std::vector<char*> argv = { const_cast<char*>(path) };
  for (const std::string& argument : arguments)
  {
    argv.push_back(const_cast<char*>(argument.c_str()));
  }
  argv.push_back(nullptr);

  const Pipe input;
  const Pipe output;
  this->Id = fork();
  if (this->Id == 0)
  {
    dup2(input.Ends[0], STDIN_FILENO);
    dup2(output.Ends[1], STDOUT_FILENO);
    execv(path, argv.data());
    _exit(NotStarted);
  }
  close(input.Ends[0]);
  close(output.Ends[1]);
  this->Input = input.Ends[1];
  this->Output = output.Ends[0];
  if (this->Id < 0)
  {
    close(this->Input);
    close(this->Output);
    throw Failure(std::string("no process: ") + std::strerror(errno));
  }
}

ChildProcess::~ChildProcess()
{
  this->end();
  close(this->Input);
  close(this->Output);
}

void ChildProcess::send(const std::string& line)
{
  const std::string text = line + "\n";
  if (write(this->Input, text.data(), text.size()) != static_cast<ssize_t>(text.size()))
  {
    throw Failure(this->waitForEnd());
  }
}

std::string ChildProcess::receive(double limitSeconds)
{
  const auto deadline = Clock::now() + std::chrono::duration<double>(limitSeconds);
  for (;;)
  {
    const auto lineEnd = this->Received.find('\n');
    if (lineEnd != std::string::npos)
    {
      const std::string line = this->Received.substr(0, lineEnd);
      this->Received.erase(0, lineEnd + 1);
      return line;
    }
    const double left = std::chrono::duration<double>(deadline - Clock::now()).count();
    pollfd waiting = { this->Output, POLLIN, 0 };
    if (poll(&waiting, 1, static_cast<int>(1000.0 * std::clamp(left, 0.0, 1.0))) <= 0)
    {
      if (left <= 0.0)
      {
        this->end();
        char text[64];
        std::snprintf(text, sizeof(text), "took more than %g s", limitSeconds);
        throw Failure(text);
      }
      continue;
    }
    char buffer[4096];
    const ssize_t count = read(this->Output, buffer, sizeof(buffer));
    if (count <= 0)
    {
      throw Failure(this->waitForEnd());
    }
    this->Received.append(buffer, static_cast<std::size_t>(count));
  }
}

std::string ChildProcess::waitForEnd()
{
  int status = 0;
  const bool known = this->Id > 0 && waitpid(this->Id, &status, 0) == this->Id;
  this->Id = -1;
  return known ? describeEnd(status) : "ended early";
}

void ChildProcess::end()
{
  if (this->Id > 0)
  {
    kill(this->Id, SIGKILL);
    this->waitForEnd();
  }
}
} // namespace tetmarch::bench
