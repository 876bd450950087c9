// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Parsing of header text: lines, words, numbers, file names.
#ifndef TetMarchImageFilesHeaderText_h
#define TetMarchImageFilesHeaderText_h

#include <charconv>
#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <vector>

namespace tetmarch
{

/** The next line without its end; false at the end of the file. Throws ImageFileError if it is too
 * long for a header. */
bool nextLine(std::istream& file, std::string& line);

std::string trimmed(const std::string& text);
std::string lowered(std::string text);
std::vector<std::string> wordsOf(const std::string& text);

/** An excerpt of a file's text for messages: up to 40 printable characters. */
std::string shown(const std::string& text);

/** Parses the text as a number; fails if other characters follow. */
template <typename Number>
std::optional<Number> numberOf(const char* begin, const char* end)
{
  begin += begin != end && *begin == '+' ? 1 : 0;
  Number number{};
  const auto result = std::from_chars(begin, end, number);
  return result.ec == std::errc() && result.ptr == end ? std::optional<Number>(number)
                                                       : std::nullopt;
}

/** The numbers of a field, separated by blanks. Throws ImageFileError with the name of the field if
 * their count differs; 0: any count. */
std::vector<double> realsOf(const std::string& field, const std::string& text, std::size_t count);
std::vector<std::int64_t> wholesOf(
  const std::string& field, const std::string& text, std::size_t count);

/** The file names of a pattern, "slice%03d.raw 1 20 1" with an optional number of axes; empty if
 * the words are no pattern. Throws ImageFileError. */
std::vector<std::string> namesOfPattern(const std::vector<std::string>& words);

/** The path of a file named in a header, relative to the header's folder. */
std::string besideHeader(const std::string& header, const std::string& name);

} // namespace tetmarch

#endif
