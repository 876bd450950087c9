// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads files as the programs do, up to the choice of what to draw, each in a process of its own:
// their names come from standard input, and a line for each goes to standard output:
//   OUTCOME<tab>KIBIBYTES<tab>MESSAGE
// where OUTCOME is "read", "refused" with a message, "reader" (a reader of VTK crashed, and that
// was told), or one that must not be: "crashed", "hung", "silent" (refused without a message),
// "unclear" (by an exception that names no file).
#include "ArrayList.h"
#include "Choice.h"
#include "DatasetReader.h"
#include "Failure.h"
#include "Messages.h"
#include "RawImage.h"
#include "ReaderCrash.h"
#include "TimeSteps.h"
#include "TransferFunctionPreset.h"
#include "ViewStateJson.h"

#include "vtkSMPTools.h"

#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <iostream>
#include <string>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{
using namespace tetmarch;

constexpr std::size_t MessageSize = 2048;
constexpr rlim_t Gigabyte = 1ull << 30;
constexpr unsigned MostSeconds = 20;

void tryFile(const std::string& path)
{
  const std::string name = std::filesystem::path(path).stem().string();
  if (name.rfind("preset", 0) == 0)
  {
    ReadPreset(path);
    return;
  }
  if (name.rfind("session", 0) == 0)
  {
    LoadSession(path);
    return;
  }
  const CommandLine options;
  const RawOptions raw = CompleteRawOptions({}, path);
  GetTimeSteps(path, raw);
  const VolumeData data = ReadVolume(path, std::nullopt, raw);
  FormatArrayList(ChooseArray(data, options), data.Times);
  MakeChoice(data, options);
}

enum Status
{
  Read,
  Refused,
  Unclear
};

// In the child process, which this ends.
[[noreturn]] void runChild(const std::string& path, char* message, int errors)
{
  const auto limit = [](auto resource, rlim_t most)
  {
    const rlimit limits{ most, most };
    setrlimit(resource, &limits);
  };
  limit(RLIMIT_CPU, MostSeconds);
  limit(RLIMIT_AS, 4 * Gigabyte);
  limit(RLIMIT_CORE, 0);
  alarm(20 * MostSeconds); // of a process that waits for what never comes
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  vtkSMPTools::Initialize(1);
  Messages::Install();
  TellCrashesOfReaders();
  int status = Read;
  std::string text;
  try
  {
    tryFile(path);
  }
  catch (const Failure& failure)
  {
    status = Refused;
    text = failure.what();
  }
  catch (const UsageError& error)
  {
    status = Refused;
    text = error.what();
  }
  catch (const std::exception& error)
  {
    status = Unclear;
    text = error.what();
  }
  std::strncpy(message, text.c_str(), MessageSize - 1);
  _exit(status);
}

std::string readAll(int file)
{
  std::string text(static_cast<std::size_t>(lseek(file, 0, SEEK_END)), ' ');
  const ssize_t count = pread(file, text.data(), text.size(), 0);
  text.resize(count < 0 ? 0 : static_cast<std::size_t>(count));
  return text;
}

std::string outcomeOf(int status, const char* message, const std::string& errors)
{
  if (WIFSIGNALED(status))
  {
    const int signal = WTERMSIG(status);
    const bool isTime = signal == SIGXCPU || signal == SIGALRM || signal == SIGKILL;
    return isTime ? "hung" : "crashed";
  }
  if (*message)
  {
    return WEXITSTATUS(status) == Unclear ? "unclear" : "refused";
  }
  return WEXITSTATUS(status) == Read                                ? "read"
         : errors.find("VTK's reader crashed") != std::string::npos ? "reader"
                                                                    : "silent";
}
} // namespace

int main(int argc, char* argv[])
{
  if (argc == 3) // --session FILE: print a session with that file instead
  {
    ViewState state;
    state.Data.File = argv[2];
    std::cout << WriteState(state);
    return 0;
  }
  auto* message = static_cast<char*>(
    mmap(nullptr, MessageSize, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
  const int errors = memfd_create("errors", 0);
  for (std::string path; std::getline(std::cin, path);)
  {
    std::memset(message, 0, MessageSize);
    if (ftruncate(errors, 0) != 0 || lseek(errors, 0, SEEK_SET) != 0)
    {
      return 1;
    }
    const pid_t child = fork();
    if (child == 0)
    {
      runChild(path, message, errors);
    }
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    std::string line = message;
    line = line.substr(0, line.find('\n'));
    if (WIFSIGNALED(status))
    {
      line = strsignal(WTERMSIG(status));
    }
    std::printf("%s\t%ld\t%s\n", outcomeOf(status, message, readAll(errors)).c_str(),
      usage.ru_maxrss, line.c_str());
    std::fflush(stdout);
  }
  return 0;
}
