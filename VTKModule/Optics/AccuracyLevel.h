// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The parameters of the levels of accuracy.
#ifndef TetMarchOpticsAccuracyLevel_h
#define TetMarchOpticsAccuracyLevel_h

#include <algorithm>
#include <cmath>

namespace tetmarch
{

struct AccuracyLevel
{
  /** Segments are split until a pixel keeps the tolerance (Shaders/gather/segment_linear.glsl);
   * otherwise none is split, or evenly where the scalar bends (segment_even.glsl). */
  bool Adaptive;
  /** The tolerance of each channel of a pixel, 0..1, for integration and early end together. If not
   * adaptive: the transmittance below which a ray ends. */
  double ErrorTolerance;
  /** Maximum number of trials to split a segment; this bounds the time of a frame. */
  int MostTrials;
  /** Minimum and maximum number of entries of the tables of transfer functions (FittingTable.h). */
  int LeastTableEntries;
  int MostTableEntries;
  /** The volume is sampled at even distances (Shaders/gather/segment_sampled.glsl), with no bound
   * of the error; otherwise it is integrated. */
  bool Sampled = false;
};

/**
 * In a cell of optical depth D in which the colour varies by V in total, sqrt(D V / (4 tolerance))
 * equal pieces keep the share of the tolerance in proportion to their absorption
 * (Shaders/gather/radiance.glsl). A cell with D V = 64 is practically opaque.
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
  Reference,
  Sampled
};

constexpr AccuracyLevel FastAccuracy{ false, 1.0 / 512.0, 1, 1024, 1024 };
constexpr AccuracyLevel DefaultAccuracy{ true, 1.0 / 255.0, 64, 1024, 65536 };
constexpr AccuracyLevel AccurateAccuracy{ true, 1.0 / 4096.0, 256, 1024, 65536 };
/** Accurate to float precision. */
constexpr AccuracyLevel ReferenceAccuracy{ true, 1e-5, 1265, 4096, 65536 };
/** As vtkGPUVolumeRayCastMapper, which ends rays at an opacity of 254/255. */
constexpr AccuracyLevel SampledAccuracy{ false, 1.0 / 255.0, 1, 1024, 65536, true };
/** The ground truth, in double precision. */
constexpr AccuracyLevel GroundTruthAccuracy{ true, 1e-6, 1000000, 4096, 262144 };

/** For rays towards the light: only their transmittance is needed, which is exact where the scalar
 * is linear. */
constexpr AccuracyLevel LightAccuracy{ false, 1.0 / 1024.0, 1, 1024, 65536 };

/** Of the ground truth: estimated error of a channel by light between the points at which it is
 * evaluated (Reference/KernelLightAtPoints.h). */
constexpr double LightTolerance = 1.0 / 4096.0;
/** Of the ground truth's rays towards the light, beside the LightTolerance. */
constexpr AccuracyLevel ExactLightAccuracy{ false, 5e-5, 1, 4096, 262144 };

/** For picks where the scalar bends: tolerance of the opacity up to the picked point. */
constexpr AccuracyLevel PickAccuracy{ true, 1.0 / 256.0, 512, 1024, 65536 };

/** The level, with the user's tolerance if it is adaptive. */
inline AccuracyLevel levelOf(Accuracy accuracy, double tolerance)
{
  constexpr AccuracyLevel levels[] = { FastAccuracy, DefaultAccuracy, AccurateAccuracy,
    ReferenceAccuracy, SampledAccuracy };
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
