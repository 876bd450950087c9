// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plot3DCheck.h"

#include "Failure.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

namespace
{
using nlohmann::json;

void CheckTypes(const std::string& path, const json& list)
{
  static const std::map<std::string, bool (*)(const json&)> typeOf = {
    { "auto-detect-format", [](const json& v) { return v.is_boolean(); } },
    { "format", [](const json& v) { return v.is_string(); } },
    { "byte-order", [](const json& v) { return v.is_string(); } },
    { "precision", [](const json& v) { return v.is_number_integer(); } },
    { "multi-grid", [](const json& v) { return v.is_boolean(); } },
    { "language", [](const json& v) { return v.is_string(); } },
    { "blanking", [](const json& v) { return v.is_boolean(); } },
    { "2D", [](const json& v) { return v.is_boolean(); } },
    { "R", [](const json& v) { return v.is_number(); } },
    { "gamma", [](const json& v) { return v.is_number(); } },
    { "functions",
      [](const json& v)
      {
        return v.is_array() && std::all_of(v.begin(), v.end(),
                                 [](const json& one) { return one.is_number_integer(); });
      } },
    { "function-names",
      [](const json& v)
      {
        return v.is_array() &&
               std::all_of(v.begin(), v.end(), [](const json& one) { return one.is_string(); });
      } },
  };
  for (const auto& [name, isRight] : typeOf)
  {
    const auto value = list.find(name);
    if (value != list.end() && !isRight(*value))
    {
      tetmarch::RefuseFile(path, "the value of \"" + name + "\" is of a wrong type");
    }
  }
}

void CheckFiles(const std::string& path, const json& step)
{
  const bool sound =
    step.is_object() && step.contains("time") && step["time"].is_number() && step.contains("xyz");
  if (!sound)
  {
    tetmarch::RefuseFile(
      path, "each entry of \"filenames\" needs a \"time\", a number, and an \"xyz\"");
  }
  for (const char* kind : { "xyz", "q", "function" })
  {
    const auto name = step.find(kind);
    if (name == step.end())
    {
      continue;
    }
    if (!name->is_string())
    {
      tetmarch::RefuseFile(path, std::string("the name of a file \"") + kind + "\" is no text");
    }
    const auto file = std::filesystem::path(path).parent_path() / name->get<std::string>();
    if (!std::filesystem::is_regular_file(file))
    {
      tetmarch::RefuseFile(path, "it lists '" + name->get<std::string>() + "', which isn't there");
    }
  }
}
} // namespace

void tetmarch::CheckPlot3D(const std::string& path)
{
  std::ifstream file(path);
  const json list = json::parse(file, nullptr, false, true);
  if (!list.is_object())
  {
    tetmarch::RefuseFile(path, "it is no JSON object");
  }
  CheckTypes(path, list);
  const auto files = list.find("filenames");
  if (files == list.end() || !files->is_array() || files->empty())
  {
    tetmarch::RefuseFile(path, "it has no list \"filenames\"");
  }
  for (const json& step : *files)
  {
    CheckFiles(path, step);
  }
}
