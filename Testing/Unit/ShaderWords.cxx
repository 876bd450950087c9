// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShaderWords.h"

#include <algorithm>
#include <iterator>

namespace tetmarch::testing
{
namespace
{
bool isOfWord(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

bool has(std::string_view text, std::string_view part)
{
  return text.find(part) != std::string_view::npos;
}
} // namespace

int ShaderWords::numberOf(const std::string& word)
{
  const auto added = this->Numbers.emplace(word, static_cast<int>(this->Names.size()));
  if (added.second)
  {
    this->Names.push_back(word);
  }
  return added.first->second;
}

// Declarations beyond functions begin where the line does, and only they do.
ShaderWords::Line ShaderWords::parsed(std::string_view text)
{
  Line line;
  line.IsLeftover = has(text, "#if") || has(text, "#elif") || has(text, "#else") ||
                    has(text, "#endif") || has(text, "TETMARCH_");
  const std::string_view code = text.substr(0, text.find("//"));
  if (code.substr(0, 5) == "#line")
  {
    return line;
  }
  char behindSecond = ' ';
  for (std::size_t at = 0; at < code.size();)
  {
    std::size_t end = at;
    while (end < code.size() && isOfWord(code[end]))
    {
      ++end;
    }
    if (end > at && (code[at] < '0' || code[at] > '9'))
    {
      line.Words.push_back(this->numberOf(std::string(code.substr(at, end - at))));
      behindSecond = line.Words.size() == 2 && end < code.size() ? code[end] : behindSecond;
    }
    at = std::max(end, at + 1);
  }
  if (!code.empty() && (isOfWord(code[0]) || code[0] == '#') && line.Words.size() > 1)
  {
    const std::string& first = this->word(line.Words[0]);
    const bool isThird = (first == "uniform" || first == "const") && line.Words.size() > 2;
    line.IsUniform = isThird && first == "uniform";
    line.IsFunction = !isThird && first != "define" && behindSecond == '(';
    line.IsStruct = first == "struct";
    if (isThird || line.IsFunction || line.IsStruct || first == "define")
    {
      this->Declared.insert(line.Words[isThird ? 2 : 1]);
    }
  }
  return line;
}

void ShaderWords::read(std::string_view text)
{
  std::fill(this->Counts.begin(), this->Counts.end(), 0);
  this->Uniforms.clear();
  this->Functions.clear();
  this->Leftover = {};
  this->Fingerprint = 1;
  bool inStruct = false;
  while (!text.empty())
  {
    const std::string_view words = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(words.size() + 1, text.size()));
    auto known = this->Lines.find(words);
    if (known == this->Lines.end())
    {
      this->Texts.emplace_back(words);
      known = this->Lines.emplace(this->Texts.back(), this->parsed(words)).first;
      known->second.Number = this->Texts.size();
      if (inStruct && known->second.Words.size() == 2)
      {
        this->Declared.insert(known->second.Words[1]);
      }
      this->Counts.resize(this->Names.size(), 0);
    }
    const Line& line = known->second;
    inStruct = line.IsStruct || (inStruct && words.substr(0, 1) != "}");
    this->Fingerprint = line.Words.empty()
                          ? this->Fingerprint
                          : (this->Fingerprint ^ line.Number) * 0x9E3779B97F4A7C15u + 1;
    for (int word : line.Words)
    {
      ++this->Counts[word];
    }
    if (line.IsUniform)
    {
      this->Uniforms.push_back(line.Words[2]);
    }
    if (line.IsFunction)
    {
      this->Functions.push_back(line.Words[1]);
    }
    this->Leftover = line.IsLeftover ? known->first : this->Leftover;
  }
}

std::vector<int> ShaderWords::declared() const
{
  std::vector<int> present;
  std::copy_if(this->Declared.begin(), this->Declared.end(), std::back_inserter(present),
    [this](int word) { return this->count(word) > 0; });
  return present;
}
} // namespace tetmarch::testing
