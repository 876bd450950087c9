// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Conditional parts of shader files: #if, #elif, #else and #endif are evaluated before the GL sees
// the text, so that no inactive code remains in it. A file may define symbols for the files that it
// includes.
#ifndef TetMarchVariantsShaderConditions_h
#define TetMarchVariantsShaderConditions_h

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace tetmarch
{

class ShaderConditions
{
public:
  /** Lines "#define NAME CONDITION". A condition has 0, 1, names, parentheses, !, && and ||. Names
   * may be defined later than they are used, and the last line of a name counts. */
  explicit ShaderConditions(std::string_view defines) { this->define(defines); }

  /** Add such lines; all others are ignored. */
  void define(std::string_view text);

  /** Whether the line, which ends with its line break, is a condition, or defines a symbol that
   * begins with TETMARCH_; if so it is evaluated, and is not part of the text. */
  bool take(std::string_view line);
  /** The error of the last condition: an unknown symbol, or another fault. Empty if there is none.
   */
  const std::string& error() const { return this->Error; }
  /** Whether the current lines are part of the variant. */
  bool isActive() const { return this->Levels.empty() || this->Levels.back().Active; }
  /** Whether each #if has its #endif. */
  bool isClosed() const { return this->Levels.empty(); }

private:
  struct Level
  {
    bool Outer;  // the lines around it are active
    bool Done;   // one of its branches was active
    bool Active; // the current branch is active
  };

  // These parse a condition from its beginning, and leave the rest.
  bool parsedValue(std::string_view& rest);
  bool parsedAnd(std::string_view& rest);
  bool parsedOr(std::string_view& rest);
  bool value(std::string_view condition);

  std::map<std::string, std::string, std::less<>> Symbols;
  std::vector<Level> Levels;
  std::string Error;
};

} // namespace tetmarch

#endif
