// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RayTotals.h"

#include <algorithm>

namespace tetmarch::testing
{
std::int64_t RayTotals::failures() const
{
  return this->Lost + this->Guarded + this->Refused + this->NotFinite + this->Negative +
         this->OutOfBound + this->NotTheAnswer;
}

RayTotals& RayTotals::operator+=(const RayTotals& other)
{
  this->Rays += other.Rays;
  this->Met += other.Met;
  this->Compared += other.Compared;
  this->Lost += other.Lost;
  this->Guarded += other.Guarded;
  this->Refused += other.Refused;
  this->NotFinite += other.NotFinite;
  this->Negative += other.Negative;
  this->OutOfBound += other.OutOfBound;
  this->NotTheAnswer += other.NotTheAnswer;
  this->WorstError = std::max(this->WorstError, other.WorstError);
  this->WorstGeneric = std::max(this->WorstGeneric, other.WorstGeneric);
  if (this->FirstFailure.empty())
  {
    this->FirstFailure = other.FirstFailure;
  }
  return *this;
}
} // namespace tetmarch::testing
