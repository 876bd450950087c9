// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Variants/ShaderConditions.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

bool beginsWith(std::string_view text, std::string_view beginning)
{
  return text.substr(0, beginning.size()) == beginning;
}

std::string_view withoutBlanks(std::string_view text)
{
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos ? std::string_view() : text.substr(first);
}

// Whether the text begins with the sign, which is then removed.
bool removed(std::string_view& rest, std::string_view sign)
{
  rest = withoutBlanks(rest);
  const bool found = beginsWith(rest, sign);
  rest.remove_prefix(found ? sign.size() : 0);
  return found;
}

std::string_view removedWord(std::string_view& rest)
{
  rest = withoutBlanks(rest);
  const auto isOfWord = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  const auto end = std::find_if_not(rest.begin(), rest.end(), isOfWord);
  const std::string_view word = rest.substr(0, static_cast<std::size_t>(end - rest.begin()));
  rest.remove_prefix(word.size());
  return word;
}

constexpr std::string_view Define = "#define ";

} // namespace

void ShaderConditions::define(std::string_view text)
{
  while (!text.empty())
  {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (beginsWith(line, Define))
    {
      line.remove_prefix(Define.size());
      const std::string_view name = removedWord(line);
      this->Symbols.insert_or_assign(std::string(name), std::string(line));
    }
  }
}

// A symbol, a condition in parentheses, or the opposite of one.
bool ShaderConditions::parsedValue(std::string_view& rest)
{
  if (removed(rest, "!"))
  {
    return !this->parsedValue(rest);
  }
  if (removed(rest, "("))
  {
    const bool inside = this->parsedOr(rest);
    this->Error = removed(rest, ")") ? this->Error : "missing )";
    return inside;
  }
  const std::string_view word = removedWord(rest);
  if (word == "0" || word == "1")
  {
    return word == "1";
  }
  const auto symbol = this->Symbols.find(word);
  if (symbol == this->Symbols.end())
  {
    this->Error = "unknown symbol " + std::string(word);
    return false;
  }
  return this->value(symbol->second);
}

bool ShaderConditions::parsedAnd(std::string_view& rest)
{
  bool all = this->parsedValue(rest);
  while (removed(rest, "&&"))
  {
    const bool next = this->parsedValue(rest);
    all = all && next;
  }
  return all;
}

bool ShaderConditions::parsedOr(std::string_view& rest)
{
  bool any = this->parsedAnd(rest);
  while (removed(rest, "||"))
  {
    const bool next = this->parsedAnd(rest);
    any = any || next;
  }
  return any;
}

bool ShaderConditions::value(std::string_view condition)
{
  const bool found = this->parsedOr(condition);
  condition = withoutBlanks(condition);
  if (!condition.empty() && this->Error.empty())
  {
    this->Error = "unexpected " + std::string(condition);
  }
  return found;
}

bool ShaderConditions::take(std::string_view line)
{
  this->Error.clear();
  if (beginsWith(line, "#define TETMARCH_"))
  {
    this->define(this->isActive() ? line : std::string_view());
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
