// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Round numbers along an axis.
 */
#ifndef tetmarch_Ticks_h
#define tetmarch_Ticks_h

#include <string>
#include <vector>

namespace tetmarch
{

struct Tick
{
  double Value;
  std::string Label;
};

/// From least to most, at most so many, at multiples of 1, 2 or 5 times a power of ten, with labels
/// that differ. None if the range is empty or there is no such number within it.
std::vector<Tick> MakeTicks(double least, double most, int atMost);

std::vector<std::string> GetLabels(const std::vector<Tick>& ticks);

} // namespace tetmarch

#endif
