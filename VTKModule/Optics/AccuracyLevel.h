// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a level of accuracy means.
#ifndef TetMarchOpticsAccuracyLevel_h
#define TetMarchOpticsAccuracyLevel_h

#include <algorithm>
#include <cmath>

namespace tetmarch
{

struct AccuracyLevel
{
  /** Segments are split until a pixel keeps the tolerance (Shaders/gather/segment_linear.glsl);
   * else each is taken as it is. */
  bool Adaptive;
  /** Of each channel of a pixel, in 0..1, for integration and early end together; if not adaptive,
   * the transmittance below which a ray ends. */
  double ErrorTolerance;
  /** A segment is taken as it is after so many; bounds the time of a frame. */
  int MostTrials;
  /** Tables of transfer functions have between so many entries and so many (FittingTable.h). */
  int LeastTableEntries;
  int MostTableEntries;
};

/**
 * Of a cell of optical depth D in which the colour varies by V in all, sqrt(D V / (4 tolerance))
 * equal pieces keep the share of the tolerance that what they absorb has
 * (Shaders/gather/radiance.glsl). D V is 64 in a cell too thick for more to be seen.
 */
inline int mostTrialsFor(double tolerance)
{
  return static_cast<int>(std::ceil(4 / std::sqrt(tolerance)));
}

/** As vtkTetMarchVolumeMapper::AccuracyLevelType. */
enum class Accuracy
{
  Fast,
  Default,
  Accurate,
  Reference
};

constexpr AccuracyLevel FastAccuracy{ false, 1.0 / 512.0, 1, 1024, 1024 };
constexpr AccuracyLevel DefaultAccuracy{ true, 1.0 / 255.0, 64, 1024, 65536 };
constexpr AccuracyLevel AccurateAccuracy{ true, 1.0 / 4096.0, 256, 1024, 65536 };
/** As much as float has. */
constexpr AccuracyLevel ReferenceAccuracy{ true, 1e-5, 1265, 4096, 65536 };
/** For comparisons in double precision. */
constexpr AccuracyLevel GroundTruthAccuracy{ true, 1e-6, 1000000, 4096, 262144 };

/** Of rays towards the light, of which only the transmittance is wanted: that is exact. */
constexpr AccuracyLevel LightAccuracy{ false, 1.0 / 1024.0, 1, 1024, 65536 };

/** A level that keeps a tolerance of the user's, too, unless it keeps none. */
inline AccuracyLevel levelOf(Accuracy accuracy, double tolerance)
{
  constexpr AccuracyLevel levels[] = { FastAccuracy, DefaultAccuracy, AccurateAccuracy,
    ReferenceAccuracy };
  AccuracyLevel level = levels[static_cast<int>(accuracy)];
  if (accuracy == Accuracy::Default)
  {
    level.ErrorTolerance = tolerance;
  }
  else if (level.Adaptive)
  {
    level.ErrorTolerance = std::min(level.ErrorTolerance, tolerance);
  }
  if (level.Adaptive)
  {
    level.MostTrials = mostTrialsFor(level.ErrorTolerance);
  }
  return level;
}

} // namespace tetmarch

#endif
