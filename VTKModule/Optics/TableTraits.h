// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Properties of transfer functions that simplify the march.
#ifndef TetMarchOpticsTableTraits_h
#define TetMarchOpticsTableTraits_h

#include <array>
#include <vector>

namespace tetmarch
{

struct TableTraits
{
  static constexpr std::array<float, 4> NothingTransparent{ { -3e38f, 3e38f, 1, 0 } };

  /**
   * Positions in the table, in entries. There is no extinction up to the first position and from
   * the second one on, nor between the third and the fourth, the widest gap between the first two.
   */
  std::array<float, 4> Transparent = NothingTransparent;
  bool ConstantColor = false; // all visible entries have the colour of the first entry

  bool hasTransparentRanges() const { return this->Transparent != NothingTransparent; }
};

/** The traits of entries r, g, b, extinction, between which the table is linear. */
TableTraits traitsOf(const std::vector<std::array<float, 4>>& entries);

} // namespace tetmarch

#endif
