// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which stored scalars are seen: what shows nothing of its scalars need not be marched through.
#ifndef TetMarchScalarsSeenScalars_h
#define TetMarchScalarsSeenScalars_h

#include "Optics/IntegralTable.h"
#include "Scalars/StoredScalar.h"

#include <cstdint>
#include <vector>

namespace tetmarch
{

/** Stored scalars 0..1 of which a table shows something; exact to the entry of the table. */
class SeenScalars
{
public:
  /** range: of the scalars that are stored. */
  SeenScalars(const IntegralTable& table, const ScalarRange& range);

  /** Whether the extinction is above 0 anywhere between them; no if low > high. */
  bool between(double low, double high) const;

private:
  double positionOf(double scalar) const { return this->Scale * scalar + this->Offset; }
  std::size_t entryOf(double position) const;

  double Scale;
  double Offset;
  std::vector<std::uint32_t> Before; // how many entries before each one have extinction
};

/** Whether one of the values, which ascend, lies between two stored scalars. */
bool isAnyBetween(const std::vector<float>& values, double low, double high);

} // namespace tetmarch

#endif
