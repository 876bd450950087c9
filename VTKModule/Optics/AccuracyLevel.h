// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a level of accuracy means. Further levels are further rows.
#ifndef TetMarchOpticsAccuracyLevel_h
#define TetMarchOpticsAccuracyLevel_h

namespace tetmarch
{

struct AccuracyLevel
{
  double
    IntegrationTolerance; // greatest error of a piece of a segment, seen through what is in front
  double LeastTransmittance; // a ray ends below it
  int MostTrials; // a segment is taken as it is after so many; bounds the time of a frame
  int TableEntries;
};

/**
 * Pixels err by less than 1/255 (largest seen: 3.5e-3) for cells of an optical depth up to 1000;
 * thicker ones with steps in their colours let several pieces use the tolerance up, to 5e-3 in all.
 */
constexpr AccuracyLevel DefaultAccuracy{ 1e-3, 1e-3, 64, 1024 };

/** For comparisons in double precision: nothing ends early. */
constexpr AccuracyLevel ReferenceAccuracy{ 1e-6, 1e-9, 1000000, 4096 };

} // namespace tetmarch

#endif
