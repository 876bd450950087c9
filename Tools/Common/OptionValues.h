// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Values of options from their text. Each function throws UsageError that says what was expected.
 */
#ifndef tetmarch_OptionValues_h
#define tetmarch_OptionValues_h

#include <initializer_list>
#include <string>
#include <vector>

namespace tetmarch
{

/// The numbers of a list "1,2,3", whose count must be one of the given ones.
std::vector<double> ParseList(const std::string& value, std::initializer_list<std::size_t> counts);

/// The same of any count but 0.
std::vector<double> ParseList(const std::string& value);

double ParsePositive(const std::string& value);

/// A number not below the least and not above the most, which are given as the user is told them.
double ParseWithin(const std::string& value, const std::string& least, const std::string& most);

/// A whole number, 0 or more.
int ParseCount(const std::string& value);

/// True for the first word, false for the second.
bool ParseChoice(const std::string& value, const std::string& yes, const std::string& no);

/// The place of a word in a list.
int ParseWord(const std::string& value, const std::vector<std::string>& words);

} // namespace tetmarch

#endif
