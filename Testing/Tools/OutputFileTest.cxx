// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Files are complete or as they were before, whatever stops the program that writes them.
#include "ReaderCase.h"

#include "OutputFile.h"

#include <csignal>
#include <fstream>
#include <sstream>
#include <sys/resource.h>
#include <sys/stat.h>
#include <thread>

namespace
{
using tetmarch::OutputFile;

class OutputFileTest : public ReaderCase
{
protected:
  std::string Read(const std::string& name) const
  {
    std::stringstream text;
    text << std::ifstream(this->GetPath(name)).rdbuf();
    return text.str();
  }
  /// Hidden ones, too.
  std::vector<std::string> ListFiles() const
  {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(this->Folder))
    {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }
  std::string GetWriteError(const std::string& path) const
  {
    try
    {
      tetmarch::WriteFile(path, "new");
    }
    catch (const tetmarch::Failure& failure)
    {
      return failure.what();
    }
    return "written";
  }
};
using Names = std::vector<std::string>;
} // namespace

TEST_F(OutputFileTest, HasItsNameWhenItIsComplete)
{
  this->WriteText("a", "old");
  {
    OutputFile file(this->GetPath("a"));
    file.Write("ne");
    EXPECT_EQ(this->Read("a"), "old");
    file.Write("w");
    EXPECT_EQ(this->ListFiles().size(), 2u);
    file.Keep();
  }
  EXPECT_EQ(this->Read("a"), "new");
  {
    OutputFile file(this->GetPath("a"));
    file.Write("given up");
  }
  EXPECT_EQ(this->Read("a"), "new");
  EXPECT_EQ(this->ListFiles(), Names{ "a" });
}

TEST_F(OutputFileTest, KeepsLinksAndPermissions)
{
  const std::string target = this->WriteText("target", "old");
  chmod(target.c_str(), 0640);
  std::filesystem::create_symlink("target", this->GetPath("relative"));
  std::filesystem::create_symlink(this->GetPath("relative"), this->GetPath("absolute"));
  std::filesystem::create_symlink("later", this->GetPath("dangling"));
  tetmarch::WriteFile(this->GetPath("absolute"), "new");
  tetmarch::WriteFile(this->GetPath("dangling"), "made");
  EXPECT_TRUE(std::filesystem::is_symlink(this->GetPath("absolute")));
  EXPECT_TRUE(std::filesystem::is_symlink(this->GetPath("relative")));
  EXPECT_EQ(this->Read("target"), "new");
  EXPECT_EQ(this->Read("later"), "made");
  struct stat after = {};
  stat(target.c_str(), &after);
  EXPECT_EQ(after.st_mode & 07777u, 0640u);
  const mode_t mask = umask(0);
  umask(mask);
  stat(this->GetPath("later").c_str(), &after);
  EXPECT_EQ(after.st_mode & 07777u, 0666u & ~mask);
}

TEST_F(OutputFileTest, RefusesWhatIsNoFile)
{
  EXPECT_EQ(this->GetWriteError("/dev/null"),
    "cannot write '/dev/null': it is a device, a pipe or a socket, not a file");
  const std::string pipe = this->GetPath("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(this->GetWriteError(pipe),
    "cannot write '" + pipe + "': it is a device, a pipe or a socket, not a file");
  EXPECT_EQ(this->GetWriteError(this->Folder.string()),
    "cannot write '" + this->Folder.string() + "': it is a folder");
  EXPECT_EQ(this->GetWriteError(this->GetPath("none/a")),
    "cannot write '" + this->GetPath("none/a") + "': there is no folder '" + this->GetPath("none") +
      "'");
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
  EXPECT_EQ(this->ListFiles(), Names{ "pipe" });
}

// What a full disk does, too: write() fails after it has taken some.
TEST_F(OutputFileTest, AFailedWriteLeavesTheOldFile)
{
  this->WriteText("a", "old");
  struct rlimit before = {};
  getrlimit(RLIMIT_FSIZE, &before);
  struct rlimit small = before;
  small.rlim_cur = 1000;
  setrlimit(RLIMIT_FSIZE, &small);
  std::string error;
  try
  {
    tetmarch::WriteFile(this->GetPath("a"), std::string(5000, 'x'));
  }
  catch (const tetmarch::Failure& failure)
  {
    error = failure.what();
  }
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(error, "cannot write '" + this->GetPath("a") + "': File too large");
  EXPECT_EQ(this->Read("a"), "old");
  EXPECT_EQ(this->ListFiles(), Names{ "a" });
}

TEST_F(OutputFileTest, ASignalLeavesTheOldFile)
{
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  this->WriteText("a", "old");
  for (const int signal : { SIGINT, SIGTERM, SIGHUP })
  {
    EXPECT_EXIT(
      {
        std::signal(signal, SIG_DFL); // a shell's background jobs ignore SIGINT
        OutputFile file(this->GetPath("a"));
        file.Write("half");
        // By any of the program's threads.
        std::thread([signal] { std::raise(signal); }).join();
      },
      testing::KilledBySignal(signal), "");
    EXPECT_EQ(this->Read("a"), "old");
    EXPECT_EQ(this->ListFiles(), Names{ "a" });
  }
}

TEST_F(OutputFileTest, AnIgnoredSignalStaysIgnored)
{
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
    {
      std::signal(SIGHUP, SIG_IGN); // as nohup has it
      OutputFile file(this->GetPath("a"));
      file.Write("whole");
      std::raise(SIGHUP);
      file.Keep();
      std::_Exit(0);
    },
    testing::ExitedWithCode(0), "");
  EXPECT_EQ(this->Read("a"), "whole");
}
