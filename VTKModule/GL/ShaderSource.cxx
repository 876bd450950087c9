// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/ShaderSource.h"

#include "TetMarchShaderFiles.h"

#include <set>
#include <sstream>

namespace tetmarch
{
namespace
{

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
  text << "#line 0 " << number << "\n";
  std::istringstream lines(ShaderFiles[number].Text);
  std::string line;
  for (int at = 1; std::getline(lines, line); ++at)
  {
    const std::string include = "#include \"";
    if (line.compare(0, include.size(), include) == 0)
    {
      append(line.substr(include.size(), line.rfind('"') - include.size()), included, text);
      text << "#line " << at << " " << number << "\n";
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

std::string sourceLegend()
{
  std::string legend;
  for (const ShaderFile& file : ShaderFiles)
  {
    legend += (legend.empty() ? "" : ", ") + std::to_string(numberOf(file.Name)) + " " + file.Name;
  }
  return legend;
}

} // namespace tetmarch
