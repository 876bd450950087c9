// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What there is about transfer functions that spares the march work.
#ifndef TetMarchOpticsTableTraits_h
#define TetMarchOpticsTableTraits_h

#include <array>
#include <vector>

namespace tetmarch
{

struct TableTraits
{
  static constexpr std::array<float, 4> NothingTransparent{ { -3e38f, 3e38f, 1, 0 } };

  /** Positions in the table, in entries: there is no extinction up to the first and from the second
   * on, nor from the third to the fourth, the widest gap between the two. */
  std::array<float, 4> Transparent = NothingTransparent;
  bool ConstantColor = false; // all that is seen has the colour of the first entry

  bool hasTransparentRanges() const { return this->Transparent != NothingTransparent; }
};

/** Of entries r, g, b, extinction, between which the table is linear. */
TableTraits traitsOf(const std::vector<std::array<float, 4>>& entries);

} // namespace tetmarch

#endif
