// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a level of accuracy means. Further levels are further rows.
#ifndef TetMarchOpticsAccuracyLevel_h
#define TetMarchOpticsAccuracyLevel_h

namespace tetmarch
{

struct AccuracyLevel
{
  double IntegrationTolerance; // greatest error of a piece of a segment, seen through what is in front
  double LeastTransmittance;   // a ray ends below it
  int TableEntries;
};

/** Pixels err by less than 1/255; the tolerances of pieces and of the early end share it. */
constexpr AccuracyLevel DefaultAccuracy{ 1e-3, 1e-3, 1024 };

/** For comparisons in double precision: nothing ends early. */
constexpr AccuracyLevel ReferenceAccuracy{ 1e-6, 1e-9, 4096 };

} // namespace tetmarch

#endif
