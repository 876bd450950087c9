// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OptionValues.h"

#include "Failure.h"
#include "Numbers.h"

#include <algorithm>

namespace tetmarch
{

std::vector<double> ParseList(const std::string& value, std::initializer_list<std::size_t> counts)
{
  const auto numbers = ParseNumbers(value, ',');
  for (std::size_t count : counts)
  {
    if (numbers && numbers->size() == count)
    {
      return *numbers;
    }
  }
  std::string expected;
  for (std::size_t count : counts)
  {
    expected += (expected.empty() ? "" : " or ") + std::to_string(count);
  }
  throw UsageError("expected " + expected + " finite numbers separated by commas");
}

std::vector<double> ParseList(const std::string& value)
{
  const auto numbers = ParseNumbers(value, ',');
  if (!numbers || numbers->empty())
  {
    throw UsageError("expected finite numbers separated by commas");
  }
  return *numbers;
}

double ParsePositive(const std::string& value)
{
  const auto number = ParseNumber(value);
  if (!number || !(*number > 0.0))
  {
    throw UsageError("expected a number above 0");
  }
  return *number;
}

double ParseWithin(const std::string& value, const std::string& least, const std::string& most)
{
  const auto number = ParseNumber(value);
  if (!number || *number < *ParseNumber(least) || *number > *ParseNumber(most))
  {
    throw UsageError("expected a number from " + least + " to " + most);
  }
  return *number;
}

int ParseCount(const std::string& value)
{
  const auto number = ParseInteger(value);
  if (!number || *number < 0)
  {
    throw UsageError("expected a whole number, 0 or more");
  }
  return *number;
}

bool ParseChoice(const std::string& value, const std::string& yes, const std::string& no)
{
  if (value != yes && value != no)
  {
    throw UsageError("expected " + yes + " or " + no);
  }
  return value == yes;
}

int ParseWord(const std::string& value, const std::vector<std::string>& words)
{
  const auto found = std::find(words.begin(), words.end(), value);
  if (found == words.end())
  {
    std::string expected = "expected " + words.front();
    for (std::size_t i = 1; i < words.size(); ++i)
    {
      expected += (i + 1 < words.size() ? ", " : " or ") + words[i];
    }
    throw UsageError(expected);
  }
  return static_cast<int>(found - words.begin());
}

} // namespace tetmarch
