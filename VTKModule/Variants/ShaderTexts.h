// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A cache of shader texts: a text takes a millisecond to build, and each tile of a picture needs
// it.
#ifndef TetMarchVariantsShaderTexts_h
#define TetMarchVariantsShaderTexts_h

#include <map>
#include <string>
#include <utility>

namespace tetmarch
{

class ShaderTexts
{
public:
  /** shaderSource(file, defines). The address of a text is constant until clear(). */
  const std::string& of(const std::string& file, const std::string& defines);
  void clear() { this->Texts.clear(); }

private:
  std::map<std::pair<std::string, std::string>, std::string> Texts;
};

} // namespace tetmarch

#endif
