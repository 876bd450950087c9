// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Budget/GrowingParts.h"

#include "Budget/TileSchedule.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

constexpr double ShareOfFrame = 0.25;
constexpr double FewUnits = 8;
constexpr double MostRaysOfFew = 16384; // a third of a second if each is the worst
constexpr std::int64_t MostUnits = std::int64_t(1) << 30;

} // namespace

void GrowingParts::begin(double raysOfUnit, double secondsOfFrame)
{
  this->Limit = ShareOfFrame * secondsOfFrame;
  const double least = std::max(1.0, std::min(FewUnits, MostRaysOfFew / raysOfUnit));
  const double units = this->Limit / (WorstRaySeconds * raysOfUnit);
  this->LeastUnits = static_cast<std::int64_t>(least);
  this->Units = static_cast<std::int64_t>(std::max(least, std::min(units, double(MostUnits))));
}

void GrowingParts::done(std::int64_t units, double seconds)
{
  if (seconds > this->Limit)
  {
    this->Units = std::max(units / 2, this->LeastUnits);
  }
  else if (2 * seconds * double(this->Units) <= this->Limit * double(units))
  {
    this->Units = std::min(2 * this->Units, MostUnits);
  }
}

} // namespace tetmarch
