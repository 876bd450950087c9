// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which parts of a shader file a variant has: #if, #elif, #else and #endif, settled before the GL
// sees the text, so that nothing of what is off is left in it. A file may define symbols for those
// that it includes.
#ifndef TetMarchVariantsShaderConditions_h
#define TetMarchVariantsShaderConditions_h

#include <string>
#include <string_view>
#include <vector>

namespace tetmarch
{

class ShaderConditions
{
public:
  /** Lines "#define NAME 1" or "#define NAME 0"; names that they lack are taken for 0. The text is
   * referred to, not copied. */
  explicit ShaderConditions(std::string_view defines)
    : Defines(defines)
  {
  }

  /** Whether the line, which ends with its line break, is a condition, or defines a symbol that
   * begins with TETMARCH_; if so it is taken account of, and is no part of the text. */
  bool take(std::string_view line);
  /** Whether what stands here is part of the variant. */
  bool isActive() const { return this->Levels.empty() || this->Levels.back().Active; }
  /** Whether each #if has had its #endif. */
  bool isClosed() const { return this->Levels.empty(); }

private:
  struct Level
  {
    bool Outer;  // what is around it is active
    bool Done;   // some branch was taken
    bool Active; // that is the one at hand
  };

  bool value(std::string_view expression) const;

  std::string_view Defines;
  std::string DefinedByFiles;
  std::vector<Level> Levels;
};

} // namespace tetmarch

#endif
