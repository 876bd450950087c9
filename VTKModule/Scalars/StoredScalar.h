// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Scalars of the march: floats in 0..1.
#ifndef TetMarchScalarsStoredScalar_h
#define TetMarchScalarsStoredScalar_h

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace tetmarch
{

/** Stored in place of a scalar that is not finite. Cells with such a scalar are not drawn. */
constexpr float UndrawnScalar = 1e30f;

/** The finite values represented by the stored scalars 0 and 1. They are equal if there is one
 * value or none. */
struct ScalarRange
{
  double Low = 0;
  double High = 0;
  bool AllFinite = true; // no value was stored as UndrawnScalar
  bool AnyFinite = true; // not every value was stored so, or there is none
  /** The difference of the values represented by the stored scalars 1 and 0: never 0. */
  double width() const { return this->High > this->Low ? this->High - this->Low : 1; }
};

/** Collects the range of the values that are finite. */
class FiniteRange
{
public:
  FiniteRange() = default;
  /** A range with these properties. */
  FiniteRange(double low, double high, bool allFinite)
    : Low(low)
    , High(high)
    , AllFinite(allFinite)
  {
  }

  void add(double value);
  void add(const FiniteRange& other);
  ScalarRange range() const;

  /** Above high() if no value is finite. */
  double low() const { return this->Low; }
  double high() const { return this->High; }
  bool isAllFinite() const { return this->AllFinite; }
  void addNotFinite() { this->AllFinite = false; }

private:
  double Low = std::numeric_limits<double>::max();
  double High = std::numeric_limits<double>::lowest();
  bool AllFinite = true;
};

inline void FiniteRange::add(double value)
{
  if (std::isfinite(value))
  {
    this->Low = std::min(this->Low, value);
    this->High = std::max(this->High, value);
  }
  else
  {
    this->AllFinite = false;
  }
}

/** The range of the values that are finite. */
FiniteRange rangeOf(const std::vector<double>& values);
inline ScalarRange finiteRange(const std::vector<double>& values)
{
  return rangeOf(values).range();
}

/** 0..1, or UndrawnScalar. The value is scaled in double precision before it is rounded. */
float storedScalar(double value, const ScalarRange& range);

} // namespace tetmarch

#endif
