// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Bits of hidden cells: bit c % 32 of word c / 32 is that of cell c. No words: no cell is hidden.
#ifndef TetMarchScalarsHiddenBits_h
#define TetMarchScalarsHiddenBits_h

#include <algorithm>
#include <cstdint>
#include <vector>

namespace tetmarch
{

/** Whether all of `cells` cells (at least one) are hidden. Stops at the first word with a cell that
 * is not. */
inline bool areAllHidden(const std::vector<std::uint32_t>& words, std::uint64_t cells)
{
  const std::uint64_t whole = cells / 32;
  const auto rest = static_cast<std::uint32_t>((std::uint64_t(1) << cells % 32) - 1);
  return !words.empty() &&
         std::all_of(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(whole),
           [](std::uint32_t word) { return word == ~std::uint32_t(0); }) &&
         (rest == 0 || (words[whole] & rest) == rest);
}

} // namespace tetmarch

#endif
