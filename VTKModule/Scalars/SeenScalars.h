// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The stored scalars that are visible: rays can skip cells with other scalars only.
#ifndef TetMarchScalarsSeenScalars_h
#define TetMarchScalarsSeenScalars_h

#include "Optics/IntegralTable.h"
#include "Scalars/StoredScalar.h"

#include <cstdint>
#include <vector>

namespace tetmarch
{

/** Neighbouring scalars that are visible: an interval of stored scalars has any of them if its low
 * end is at most MostLow, and its high end at least LeastHigh. */
struct SeenRun
{
  float LeastHigh;
  float MostLow;
};

inline bool operator==(const SeenRun& a, const SeenRun& b)
{
  return a.LeastHigh == b.LeastHigh && a.MostLow == b.MostLow;
}

/** The stored scalars 0..1 that are visible by a table; exact to the entry of the table. */
class SeenScalars
{
public:
  /** range: of the stored scalars. */
  SeenScalars(const IntegralTable& table, const ScalarRange& range);

  /** Whether the extinction is above 0 anywhere between them; no if low > high. */
  bool between(double low, double high) const;
  /** The same for many intervals of floats: ascending runs, at least one of which each visible
   * interval has. */
  std::vector<SeenRun> runs() const;

private:
  std::size_t firstEntry(double low) const;
  std::size_t lastEntry(double high) const;
  double positionOf(double scalar) const { return this->Scale * scalar + this->Offset; }
  std::size_t entryOf(double position) const;

  double Scale;
  double Offset;
  std::vector<std::uint32_t> Before; // number of entries with extinction before each one
};

/** Whether one of the ascending values lies between two stored scalars. */
bool isAnyBetween(const std::vector<float>& values, double low, double high);
/** The same for many intervals: a run for each value. */
std::vector<SeenRun> runsAround(const std::vector<float>& values);

} // namespace tetmarch

#endif
