// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageFiles/HeaderText.h"

#include "ImageFiles/ImageHeader.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <sstream>

namespace tetmarch
{
namespace
{

constexpr std::size_t LongestLine = 65536;
constexpr std::int64_t MostFiles = 1000000;

template <typename Number>
std::vector<Number> numbersOf(const std::string& field, const std::string& text, std::size_t count)
{
  std::vector<Number> numbers;
  for (const std::string& word : wordsOf(text))
  {
    const auto number = numberOf<Number>(word.data(), word.data() + word.size());
    if (!number)
    {
      throw ImageFileError(
        "in the field '" + field + "' of its header '" + shown(word) + "' is no number");
    }
    numbers.push_back(*number);
  }
  if (count > 0 && numbers.size() != count)
  {
    throw ImageFileError("the field '" + field + "' of its header has " +
                         std::to_string(numbers.size()) + " numbers instead of " +
                         std::to_string(count));
  }
  return numbers;
}

// The position of %d, %3d or %03d in a pattern; the rest is text.
struct NumberPlace
{
  std::size_t Begin = 0;
  std::size_t End = 0;
  std::size_t Width = 0;
  char Fill = ' ';
};

std::optional<NumberPlace> findPlace(const std::string& pattern)
{
  NumberPlace place;
  place.Begin = pattern.find('%');
  std::size_t at = place.Begin == std::string::npos ? pattern.size() : place.Begin + 1;
  if (at < pattern.size() && pattern[at] == '0')
  {
    place.Fill = '0';
    ++at;
  }
  for (; at < pattern.size() && std::isdigit(static_cast<unsigned char>(pattern[at])); ++at)
  {
    place.Width = std::min<std::size_t>(10 * place.Width + (pattern[at] - '0'), 100);
  }
  place.End = at + 1;
  const bool isOne = at < pattern.size() && (pattern[at] == 'd' || pattern[at] == 'i') &&
                     pattern.find('%', at) == std::string::npos;
  return isOne ? std::optional<NumberPlace>(place) : std::nullopt;
}

} // namespace

bool nextLine(std::istream& file, std::string& line)
{
  line.clear();
  int character = file.get();
  if (character == std::istream::traits_type::eof())
  {
    return false;
  }
  for (; character != '\n' && character != std::istream::traits_type::eof(); character = file.get())
  {
    line += static_cast<char>(character);
    if (line.size() > LongestLine)
    {
      throw ImageFileError("a line of its header has more than 65536 characters");
    }
  }
  if (!line.empty() && line.back() == '\r')
  {
    line.pop_back();
  }
  return true;
}

std::string trimmed(const std::string& text)
{
  const char* blanks = " \t\r\n\v\f";
  const std::size_t begin = text.find_first_not_of(blanks);
  return begin == std::string::npos ? std::string()
                                    : text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

std::string lowered(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::vector<std::string> wordsOf(const std::string& text)
{
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
  {
    words.push_back(word);
  }
  return words;
}

std::string shown(const std::string& text)
{
  std::string start = text.substr(0, 40);
  for (char& c : start)
  {
    c = c >= ' ' && c <= '~' ? c : '?';
  }
  return start + (text.size() > 40 ? "..." : "");
}

std::vector<double> realsOf(const std::string& field, const std::string& text, std::size_t count)
{
  return numbersOf<double>(field, text, count);
}

std::vector<std::int64_t> wholesOf(
  const std::string& field, const std::string& text, std::size_t count)
{
  return numbersOf<std::int64_t>(field, text, count);
}

std::vector<std::string> namesOfPattern(const std::vector<std::string>& words)
{
  const auto place =
    words.size() == 4 || words.size() == 5 ? findPlace(words[0]) : std::optional<NumberPlace>();
  if (!place)
  {
    return {};
  }
  const auto numbers = wholesOf("data file", words[1] + " " + words[2] + " " + words[3], 3);
  const auto [first, last, step] = std::array{ numbers[0], numbers[1], numbers[2] };
  const bool sound = first >= 0 && last >= 0 && first <= MostFiles && last <= MostFiles &&
                     step != 0 && std::abs(step) <= MostFiles && (last - first) / step >= 0;
  if (!sound)
  {
    throw ImageFileError("its header numbers its files from " + words[1] + " to " + words[2] +
                         " in steps of " + words[3] + ", which names no files");
  }
  std::vector<std::string> names;
  for (std::int64_t number = first; step > 0 ? number <= last : number >= last; number += step)
  {
    const std::string text = std::to_string(number);
    const std::string fill(place->Width - std::min(place->Width, text.size()), place->Fill);
    names.push_back(words[0].substr(0, place->Begin) + fill + text + words[0].substr(place->End));
  }
  return names;
}

std::string besideHeader(const std::string& header, const std::string& name)
{
  return (std::filesystem::path(header).parent_path() / name).string();
}

} // namespace tetmarch
