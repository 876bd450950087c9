// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The words of a shader's text, fast enough for tens of thousands of texts out of the same lines.
#ifndef tetmarch_testing_ShaderWords_h
#define tetmarch_testing_ShaderWords_h

#include <cstdint>
#include <deque>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace tetmarch::testing
{
class ShaderWords
{
public:
  /// Words are numbered as they come, and keep their numbers.
  int numberOf(const std::string& word);
  const std::string& word(int number) const { return this->Names[number]; }

  /// The words of this text, in the place of those of the last one. Comments have none.
  void read(std::string_view text);
  int count(int word) const
  {
    return static_cast<std::size_t>(word) < this->Counts.size() ? this->Counts[word] : 0;
  }
  /// What is declared beyond functions: uniforms, and functions themselves.
  const std::vector<int>& uniforms() const { return this->Uniforms; }
  const std::vector<int>& functions() const { return this->Functions; }
  /// A line with a condition, or a symbol of one; empty if there is none.
  std::string_view leftover() const { return this->Leftover; }
  /// What of the text some text declares, in ascending order: functions, uniforms, structs and
  /// their members, constants and macros.
  std::vector<int> declared() const;
  /// Equal if all lines are that have words.
  std::uint64_t fingerprint() const { return this->Fingerprint; }

private:
  struct Line
  {
    std::uint64_t Number = 0;
    std::vector<int> Words;
    bool IsUniform = false;
    bool IsFunction = false;
    bool IsStruct = false;
    bool IsLeftover = false;
  };
  Line parsed(std::string_view text);

  std::map<std::string, int> Numbers;
  std::vector<std::string> Names;
  std::set<int> Declared;
  std::deque<std::string> Texts; // of the lines
  std::unordered_map<std::string_view, Line> Lines;

  std::vector<int> Counts;
  std::vector<int> Uniforms;
  std::vector<int> Functions;
  std::string_view Leftover;
  std::uint64_t Fingerprint = 0;
};
} // namespace tetmarch::testing

#endif
