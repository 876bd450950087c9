// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Runs every file of the folders, or every file, that the arguments name.
#include "Exercise.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

int main(int argc, char** argv)
{
  namespace fs = std::filesystem;
  std::vector<fs::path> files;
  for (int i = 1; i < argc; ++i)
  {
    if (fs::is_directory(argv[i]))
    {
      for (const auto& entry : fs::directory_iterator(argv[i]))
      {
        files.push_back(entry.path());
      }
    }
    else
    {
      files.emplace_back(argv[i]);
    }
  }
  std::sort(files.begin(), files.end());
  int marched = 0;
  for (const fs::path& file : files)
  {
    std::printf("%s: ", file.filename().c_str());
    std::fflush(stdout);
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
    {
      std::printf("can't be read\n");
      return 1;
    }
    const std::string outcome = tetmarch::testing::exercise(
      { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() });
    std::printf("%s\n", outcome.empty() ? "marched" : outcome.c_str());
    marched += outcome.empty() ? 1 : 0;
  }
  std::printf("%d of %d files marched\n", marched, static_cast<int>(files.size()));
  return marched > 0 ? 0 : 1; // folders that hold nothing prove nothing
}
