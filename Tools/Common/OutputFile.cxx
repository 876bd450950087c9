// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OutputFile.h"

#include "Failure.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <random>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace
{
namespace fs = std::filesystem;

std::mutex OneAtATime;
std::atomic<const char*> Unfinished{ nullptr }; // the name of the temporary file

/// Ends the program as the signal does by default. Calls nothing that a handler must not call.
void RemoveAndEnd(int signal)
{
  if (const char* name = Unfinished.exchange(nullptr))
  {
    unlink(name);
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

constexpr std::array<int, 3> EndingSignals = { SIGHUP, SIGINT, SIGTERM };

/// Signals that the program ignores or handles stay as they are. A file above the limit of `ulimit
/// -f` is an error of write(), not the end of the program.
void WatchSignals()
{
  for (const int signal : EndingSignals)
  {
    struct sigaction action = {};
    sigaction(signal, nullptr, &action);
    if (!(action.sa_flags & SA_SIGINFO) && action.sa_handler == SIG_DFL)
    {
      action.sa_handler = RemoveAndEnd;
      sigaction(signal, &action, nullptr);
    }
  }
  std::signal(SIGXFSZ, SIG_IGN);
}

std::string FollowLinks(const std::string& path)
{
  constexpr int most = 40; // as Linux has it
  fs::path target(path);
  std::error_code error;
  for (int i = 0; i < most && fs::is_symlink(target, error); ++i)
  {
    const fs::path next = fs::read_symlink(target, error);
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  return target.string();
}

fs::path GetFolder(const fs::path& path)
{
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// That no other file has.
std::string MakeTemporaryName(const std::string& target)
{
  std::random_device random;
  return (
    GetFolder(target) / (".tetmarch-" + std::to_string(getpid()) + "-" + std::to_string(random())))
    .string();
}

std::string FindProblem(const std::string& path, const std::string& target)
{
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status))
  {
    return "it is a folder";
  }
  if (fs::exists(status) && !fs::is_regular_file(status))
  {
    return "it is a device, a pipe or a socket, not a file";
  }
  const fs::path folder = GetFolder(target);
  if (!fs::is_directory(folder, error))
  {
    return "there is no folder '" + folder.string() + "'";
  }
  if (fs::exists(status) && access(target.c_str(), W_OK) != 0)
  {
    return std::strerror(errno);
  }
  return access(folder.c_str(), W_OK | X_OK) == 0
           ? std::string()
           : "folder '" + folder.string() + "': " + std::strerror(errno);
}

tetmarch::Failure MakeFailure(const std::string& path, const std::string& reason)
{
  return tetmarch::Failure("cannot write '" + path + "': " + reason);
}
} // namespace

namespace tetmarch
{

OutputFile::OutputFile(const std::string& path)
  : Lock(OneAtATime)
  , Path(path)
  , Target(FollowLinks(path))
{
  const std::string problem = FindProblem(path, this->Target);
  if (!problem.empty())
  {
    throw MakeFailure(path, problem);
  }
  this->Temporary = MakeTemporaryName(this->Target);
  Unfinished = this->Temporary.c_str();
  WatchSignals();
  this->Descriptor =
    open(this->Temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode_t(0666));
  if (this->Descriptor < 0)
  {
    const int error = errno;
    Unfinished = nullptr;
    throw MakeFailure(path, std::strerror(error));
  }
  struct stat before = {};
  if (stat(this->Target.c_str(), &before) == 0)
  {
    fchmod(this->Descriptor, before.st_mode & mode_t(07777));
  }
}

OutputFile::~OutputFile()
{
  if (this->Descriptor >= 0)
  {
    close(this->Descriptor);
  }
  if (!this->Temporary.empty())
  {
    unlink(this->Temporary.c_str());
  }
  Unfinished = nullptr;
}

void OutputFile::Write(std::string_view bytes)
{
  while (!bytes.empty())
  {
    const ssize_t written = write(this->Descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR)
    {
      throw MakeFailure(this->Path, std::strerror(errno));
    }
    bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
  }
}

void OutputFile::Keep()
{
  const int descriptor = this->Descriptor;
  this->Descriptor = -1;
  // Some file systems tell only here that the disk is full.
  if (close(descriptor) != 0 || rename(this->Temporary.c_str(), this->Target.c_str()) != 0)
  {
    throw MakeFailure(this->Path, std::strerror(errno));
  }
  this->Temporary.clear();
}

void WriteFile(const std::string& path, std::string_view bytes)
{
  OutputFile file(path);
  file.Write(bytes);
  file.Keep();
}

std::string FindOutputProblem(const std::string& path)
{
  return FindProblem(path, FollowLinks(path));
}

} // namespace tetmarch
