// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Values of options that are more than a number or a word. Each throws UsageError that says what
 * was expected.
 */
#ifndef tetmarch_OptionParsers_h
#define tetmarch_OptionParsers_h

#include "CommandLine.h"

#include <array>
#include <string>
#include <vector>

namespace tetmarch
{

std::array<int, 2> ParseSize(const std::string& value);
std::array<int, 2> ParsePixel(const std::string& value);
std::array<double, 3> ParseColor(const std::string& value);
std::array<double, 2> ParseRange(const std::string& value);
CameraOption ParseCamera(const std::string& value);
/// Red, green, blue and opacity.
std::vector<double> ParseNanColor(const std::string& value);
/// Magnitudes and opacities.
std::vector<std::array<double, 2>> ParseGradientOpacity(const std::string& value);
/// -1: the magnitude.
int ParseComponent(const std::string& value);
TimeRange ParseTimeRange(const std::string& value);
/// A whole number from least to most.
int ParseWholeWithin(const std::string& value, int least, int most);

} // namespace tetmarch

#endif
