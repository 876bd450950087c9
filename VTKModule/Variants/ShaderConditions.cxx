// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Variants/ShaderConditions.h"

namespace tetmarch
{
namespace
{

bool beginsWith(std::string_view text, std::string_view beginning)
{
  return text.substr(0, beginning.size()) == beginning;
}

std::string_view trimmed(std::string_view text)
{
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string_view::npos
           ? std::string_view()
           : text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

} // namespace

// Of symbols with !, && and ||, without parentheses: what the shaders need.
bool ShaderConditions::value(std::string_view expression) const
{
  const std::size_t either = expression.find("||");
  if (either != std::string_view::npos)
  {
    return this->value(expression.substr(0, either)) || this->value(expression.substr(either + 2));
  }
  const std::size_t both = expression.find("&&");
  if (both != std::string_view::npos)
  {
    return this->value(expression.substr(0, both)) && this->value(expression.substr(both + 2));
  }
  const std::string_view symbol = trimmed(expression);
  if (beginsWith(symbol, "!"))
  {
    return !this->value(symbol.substr(1));
  }
  const std::string define = "#define " + std::string(symbol) + " 1\n";
  return this->Defines.find(define) != std::string_view::npos ||
         this->DefinedByFiles.find(define) != std::string::npos;
}

bool ShaderConditions::take(std::string_view line)
{
  if (beginsWith(line, "#define TETMARCH_"))
  {
    this->DefinedByFiles += this->isActive() ? line : std::string_view();
    return true;
  }
  if (beginsWith(line, "#if "))
  {
    const bool outer = this->isActive();
    const bool active = outer && this->value(line.substr(4));
    this->Levels.push_back({ outer, active, active });
    return true;
  }
  if (this->Levels.empty())
  {
    return false;
  }
  Level& level = this->Levels.back();
  if (beginsWith(line, "#elif "))
  {
    level.Active = level.Outer && !level.Done && this->value(line.substr(6));
    level.Done = level.Done || level.Active;
    return true;
  }
  if (beginsWith(line, "#else"))
  {
    level.Active = level.Outer && !level.Done;
    level.Done = true;
    return true;
  }
  if (beginsWith(line, "#endif"))
  {
    this->Levels.pop_back();
    return true;
  }
  return false;
}

} // namespace tetmarch
