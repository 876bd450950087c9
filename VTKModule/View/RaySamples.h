// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Positions of samples along rays at the accuracy level Sampled.
#ifndef TetMarchViewRaySamples_h
#define TetMarchViewRaySamples_h

#include "Geometry/VolumeFrame.h"

#include <array>
#include <string>

namespace tetmarch
{

struct RaySamples
{
  double Distance = 0; // between samples, in units of the data
  /** The first sample is a fraction of a step behind the begin of the ray, different for each
   * pixel; else a whole step. */
  bool Jitters = false;

  /** Distance between samples, in depths. */
  double step(const VolumeFrame& frame) const { return this->Distance / frame.Radius; }
  /** Distance of the first sample from the begin of the ray, in steps: noise times the first
   * number, plus the second. */
  std::array<float, 2> shift() const
  {
    return this->Jitters ? std::array<float, 2>{ { 1, 0 } } : std::array<float, 2>{ { 0, 1 } };
  }
};

/** Maximum number of samples of a ray, distinguishable by float depths. */
constexpr double MostSamples = 1e6;

/** The error of the distance, with its remedy; empty if it is valid. */
std::string describeBadDistance(const RaySamples& samples, const VolumeFrame& frame);

} // namespace tetmarch

#endif
