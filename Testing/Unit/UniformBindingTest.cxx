// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The uniforms of a file of Shaders/..._buffers.glsl are bound in one file of VTKModule/GL. Files
// of different kinds of volumes may have uniforms of the same name; each kind binds its own.
#include <algorithm>
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

// The sources that name the uniform.
std::set<std::string> usersOf(
  const std::string& uniform, const std::map<std::string, std::string>& sources)
{
  std::set<std::string> users;
  for (const auto& [source, text] : sources)
  {
    if (text.find('"' + uniform + '"') != std::string::npos)
    {
      users.insert(source);
    }
  }
  return users;
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
  std::map<std::string, std::set<std::string>> declared; // uniforms, by file
  std::map<std::string, std::size_t> files;              // that declare a uniform
  for (const auto& entry : fs::recursive_directory_iterator(TETMARCH_SHADER_DIR))
  {
    const std::string name = entry.path().filename().string();
    if (name.find("_buffers.glsl") != std::string::npos)
    {
      const std::set<std::string> uniforms = uniformsOf(textOf(entry.path()));
      EXPECT_EQ(uniforms.empty(), name == "volume_buffers.glsl") << name;
      for (const std::string& uniform : uniforms)
      {
        ++files[uniform];
      }
      declared[name] = uniforms;
    }
  }
  declared.erase("volume_buffers.glsl"); // it chooses among the others
  for (const auto& [file, uniforms] : declared)
  {
    std::set<std::string> binders;
    for (const auto& [source, text] : sources)
    {
      binders.insert(source);
    }
    for (const std::string& uniform : uniforms)
    {
      const std::set<std::string> users = usersOf(uniform, sources);
      EXPECT_EQ(users.size(), files[uniform]) << file << ": " << uniform;
      std::set<std::string> both;
      std::set_intersection(binders.begin(), binders.end(), users.begin(), users.end(),
        std::inserter(both, both.end()));
      binders = both;
    }
    EXPECT_EQ(binders.size(), 1u) << file << ", by " << testing::PrintToString(binders);
  }
  EXPECT_GT(declared.size(), 8u);
}
} // namespace
