// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/ShaderSource.h"

#include "TetMarchShaderFiles.h"

#include <iterator>
#include <regex>
#include <set>
#include <sstream>

namespace tetmarch
{
namespace
{

// Lines of all files are numbered on, a thousand a file. There are source numbers for that, but
// Mesa says 0 of most errors.
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

void append(const std::string& file, std::set<std::string>& included, std::ostringstream& text)
{
  const int number = numberOf(file);
  if (number < 0 || !included.insert(file).second)
  {
    return;
  }
  // In GLSL 1.50 the line behind a #line directive has the number after the one it names.
  const int firstLine = (number + 1) * NumbersPerFile;
  text << "#line " << firstLine << "\n";
  std::istringstream lines(ShaderFiles[number].Text);
  std::string line;
  for (int at = 1; std::getline(lines, line); ++at)
  {
    const std::string include = "#include \"";
    if (line.compare(0, include.size(), include) == 0)
    {
      append(line.substr(include.size(), line.rfind('"') - include.size()), included, text);
      text << "#line " << firstLine + at << "\n";
    }
    else
    {
      text << line << "\n";
    }
  }
}

} // namespace

std::string shaderSource(const std::string& file, const std::string& defines)
{
  std::ostringstream text;
  text << "//VTK::System::Dec\n" << defines;
  std::set<std::string> included;
  append(file, included, text);
  return text.str();
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
