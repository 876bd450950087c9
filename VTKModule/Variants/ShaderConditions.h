// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which parts of a shader file a variant has: #if, #elif, #else and #endif, settled before the GL
// sees the text, so that nothing of what is off is left in it. A file may define symbols for those
// that it includes.
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

  /** Further lines of that kind; all others are ignored. */
  void define(std::string_view text);

  /** Whether the line, which ends with its line break, is a condition, or defines a symbol that
   * begins with TETMARCH_; if so it is obeyed, and is no part of the text. */
  bool take(std::string_view line);
  /** What is wrong with the condition in the line that was taken last: an unknown symbol, or
   * another fault in it. Empty if nothing is. */
  const std::string& error() const { return this->Error; }
  /** Whether the lines at this place are part of the variant. */
  bool isActive() const { return this->Levels.empty() || this->Levels.back().Active; }
  /** Whether each #if has had its #endif. */
  bool isClosed() const { return this->Levels.empty(); }

private:
  struct Level
  {
    bool Outer;  // the lines around it are active
    bool Done;   // one of its branches was active
    bool Active; // the present one is
  };

  // These parse a condition from its begin, and leave the rest.
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
