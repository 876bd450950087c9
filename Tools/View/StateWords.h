// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The words of choices that are no settings, in the order of their numbers: those of
 * tetmarch-render, which sessions have, too. SettingsState.h has those of settings.
 */
#ifndef tetmarch_StateWords_h
#define tetmarch_StateWords_h

#include <array>
#include <string>
#include <string_view>

namespace tetmarch
{

inline constexpr std::array<const char*, 6> BlendWords = { "composite", "maximum", "minimum",
  "average", "additive", "isosurface" };
inline constexpr std::array<const char*, 6> ColorSpaceWords = { "RGB", "HSV", "CIELAB", "Diverging",
  "Lab/CIEDE2000", "Step" };

/// The number of a word, or -1.
template <std::size_t Count>
int FindWord(const std::array<const char*, Count>& words, std::string_view word)
{
  for (std::size_t i = 0; i < Count; ++i)
  {
    if (word == words[i])
    {
      return static_cast<int>(i);
    }
  }
  return -1;
}

} // namespace tetmarch

#endif
