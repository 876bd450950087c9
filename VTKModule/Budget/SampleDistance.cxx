// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Budget/SampleDistance.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{
namespace
{

// The number of rays increases only if the next frame is expected to take at most this share of its
// time.
constexpr double Haste = 0.7;

// The smallest power of the square root of 2 that keeps the time.
double distanceFor(double fullSeconds, double seconds)
{
  const double halvings = std::log2(fullSeconds / seconds);
  return halvings <= 0 ? 1 : std::pow(2, 0.5 * std::ceil(halvings));
}

} // namespace

double SampleDistance::choose(double seconds, double least, double most)
{
  double distance = 1;
  if (this->FullSeconds > 0 && seconds > 0)
  {
    distance = distanceFor(this->FullSeconds, seconds);
    if (distance < this->Distance)
    {
      distance = std::min(this->Distance, distanceFor(this->FullSeconds, Haste * seconds));
    }
  }
  this->Distance = std::min(std::max(distance, least), std::max(least, most));
  return this->Distance;
}

void SampleDistance::drawn(double distance, double seconds)
{
  this->FullSeconds = seconds * distance * distance;
}

} // namespace tetmarch
