// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Variants/ShaderSource.h"

#include "TetMarchShaderFiles.h"
#include "Variants/ShaderConditions.h"

#include <algorithm>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string_view>

namespace tetmarch
{
namespace
{

// Line numbers continue from file to file, a thousand per file. GLSL has source string numbers, but
// Mesa reports the number 0 for most errors.
constexpr int NumbersPerFile = 1000;

int numberOf(const std::string& file)
{
  int number = 0;
  for (const ShaderFile& known : ShaderFiles)
  {
    if (file == known.Name)
    {
      return number;
    }
    ++number;
  }
  return -1;
}

// Without streams, which lose text silently if memory is short.
void append(const std::string& file, ShaderConditions& conditions, std::set<std::string>& included,
  std::string& text)
{
  const int number = numberOf(file);
  if (number < 0 || !included.insert(file).second)
  {
    return;
  }
  // In GLSL 1.50 the line after a #line directive has the number after the given one.
  int line = (number + 1) * NumbersPerFile;
  bool numbered = false; // the line follows the last one of the text
  const std::string_view include = "#include \"";
  std::string_view rest = ShaderFiles[number].Text;
  while (!rest.empty())
  {
    ++line;
    const std::size_t end = std::min(rest.find('\n'), rest.size() - 1) + 1;
    const std::string_view words = rest.substr(0, end);
    rest.remove_prefix(end);
    if (conditions.take(words) || !conditions.isActive())
    {
      text += conditions.error().empty()
                ? std::string()
                : "#line " + std::to_string(line - 1) + "\n#error " + conditions.error() + "\n";
      numbered = false;
    }
    else if (words.substr(0, include.size()) == include)
    {
      const std::string_view name = words.substr(include.size());
      append(std::string(name.substr(0, name.find('"'))), conditions, included, text);
      numbered = false;
    }
    else
    {
      if (!numbered)
      {
        text += "#line " + std::to_string(line - 1) + "\n";
        numbered = true;
      }
      text += words;
    }
  }
}

} // namespace

std::string shaderSource(const std::string& file, const std::string& defines)
{
  std::string text = "//VTK::System::Dec\n";
  std::set<std::string> included;
  ShaderConditions conditions(defines);
  conditions.define(ShaderFiles[numberOf("derived_conditions.glsl")].Text);
  append(file, conditions, included, text);
  return text;
}

std::string withFileNames(const std::string& log)
{
  static const std::regex place("^((?:ERROR: |WARNING: )?)[0-9]+[:(]([0-9]{4,6})\\)?");
  std::string named;
  std::istringstream lines(log);
  std::string line;
  while (std::getline(lines, line))
  {
    std::smatch match;
    if (std::regex_search(line, match, place))
    {
      const int number = std::stoi(match[2]);
      const int file = number / NumbersPerFile - 1;
      if (file < static_cast<int>(std::size(ShaderFiles)))
      {
        line = match[1].str() + ShaderFiles[file].Name + ":" +
               std::to_string(number % NumbersPerFile) + match.suffix().str();
      }
    }
    named += (named.empty() ? "" : "\n") + line;
  }
  return named;
}

} // namespace tetmarch
