// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What became of many rays
 */
#ifndef tetmarch_testing_RayTotals_h
#define tetmarch_testing_RayTotals_h

#include <cstdint>
#include <string>

namespace tetmarch::testing
{
/// Sums over rays. All but Rays, Met, Compared and the worst are failures.
struct RayTotals
{
  std::int64_t Rays = 0;
  std::int64_t Met = 0;      ///< met the mesh
  std::int64_t Compared = 0; ///< with brute force or the box
  std::int64_t Lost = 0;
  std::int64_t Guarded = 0;
  std::int64_t Refused = 0;
  std::int64_t NotFinite = 0;    ///< NaN, infinite or not in 0..1
  std::int64_t Negative = 0;     ///< a length below 0
  std::int64_t OutOfBound = 0;   ///< float against double
  std::int64_t NotTheAnswer = 0; ///< float against the box, double against brute force
  double WorstError = 0.0;       ///< of a length, in mesh radii, against the box or double
  double WorstGeneric = 0.0;     ///< the same for rays without any tie or grazing by construction
  std::string FirstFailure;      ///< the ray of it

  std::int64_t failures() const;
  RayTotals& operator+=(const RayTotals& other);
};
} // namespace tetmarch::testing

#endif
