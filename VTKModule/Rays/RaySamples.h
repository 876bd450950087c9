// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Where rays look a volume up that is sampled at even distances instead of integrated.
#ifndef TetMarchRaysRaySamples_h
#define TetMarchRaysRaySamples_h

#include "Geometry/VolumeFrame.h"

#include <array>
#include <string>

namespace tetmarch
{

struct RaySamples
{
  double Distance = 0; // from sample to sample, in units of the data
  /** The first sample lies a fraction of a step behind where the ray begins, another one for each
   * pixel; else a whole step. */
  bool Jitters = false;

  /** From sample to sample, in depths. */
  double step(const VolumeFrame& frame) const { return this->Distance / frame.Radius; }
  /** The first sample lies so many steps behind where the ray begins: noise times the first number,
   * plus the second. */
  std::array<float, 2> shift() const
  {
    return this->Jitters ? std::array<float, 2>{ { 1, 0 } } : std::array<float, 2>{ { 0, 1 } };
  }
};

/** No ray takes more samples: depths of float tell them apart. */
constexpr double MostSamples = 1e6;

/** What is wrong with the distance, and what to do; empty: nothing. */
std::string describeBadDistance(const RaySamples& samples, const VolumeFrame& frame);

} // namespace tetmarch

#endif
