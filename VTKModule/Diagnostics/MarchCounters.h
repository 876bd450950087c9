// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Counters of the march.
#ifndef TetMarchDiagnosticsMarchCounters_h
#define TetMarchDiagnosticsMarchCounters_h

#include <cstdint>

namespace tetmarch
{

/** Sums over the rays of a picture; the last three are normally 0. */
struct MarchCounters
{
  std::int64_t Rays = 0;    // that entered the mesh
  std::int64_t Cells = 0;   // tetrahedra crossed
  std::int64_t Lookups = 0; // of the segment integral
  std::int64_t Refused = 0; // entry faces that refused the ray
  std::int64_t Lost = 0;    // tetrahedra without an exit
  std::int64_t Guarded = 0; // marches stopped by the step guard

  MarchCounters& operator+=(const MarchCounters& other)
  {
    this->Rays += other.Rays;
    this->Cells += other.Cells;
    this->Lookups += other.Lookups;
    this->Refused += other.Refused;
    this->Lost += other.Lost;
    this->Guarded += other.Guarded;
    return *this;
  }
};

} // namespace tetmarch

#endif
