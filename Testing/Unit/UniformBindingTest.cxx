// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The uniforms of a file of Shaders/..._buffers.glsl are bound in one file of VTKModule/GL.
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace
{
namespace fs = std::filesystem;

std::string textOf(const fs::path& file)
{
  std::ifstream stream(file);
  return { std::istreambuf_iterator<char>(stream), {} };
}

std::set<std::string> uniformsOf(const std::string& text)
{
  const std::regex declaration("uniform \\w+ (\\w+)[;\\[]");
  std::set<std::string> names;
  for (std::sregex_iterator it(text.begin(), text.end(), declaration), end; it != end; ++it)
  {
    names.insert((*it)[1]);
  }
  return names;
}

TEST(UniformBinding, OfAFileIsInOneFile)
{
  std::map<std::string, std::string> sources;
  for (const auto& entry : fs::directory_iterator(fs::path(TETMARCH_SOURCE_DIR) / "VTKModule/GL"))
  {
    if (entry.path().extension() == ".cxx" || entry.path().extension() == ".h")
    {
      sources[entry.path().filename().string()] = textOf(entry.path());
    }
  }
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(TETMARCH_SHADER_DIR))
  {
    const std::string name = entry.path().filename().string();
    if (name.find("_buffers.glsl") == std::string::npos)
    {
      continue;
    }
    ++files;
    std::set<std::string> binders;
    const std::set<std::string> uniforms = uniformsOf(textOf(entry.path()));
    EXPECT_FALSE(uniforms.empty()) << name;
    for (const std::string& uniform : uniforms)
    {
      std::set<std::string> users;
      for (const auto& [source, text] : sources)
      {
        if (text.find('"' + uniform + '"') != std::string::npos)
        {
          users.insert(source);
        }
      }
      EXPECT_EQ(users.size(), 1u) << name << ": " << uniform;
      binders.insert(users.begin(), users.end());
    }
    EXPECT_EQ(binders.size(), 1u) << name << ", by " << testing::PrintToString(binders);
  }
  EXPECT_GT(files, 8);
}
} // namespace
