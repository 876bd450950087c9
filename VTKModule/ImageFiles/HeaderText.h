// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The text of headers: lines, words, numbers, names of files.
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

/** The next line without its end; false at the end of the file. Throws ImageFileError if it is
 * longer than any header's. */
bool nextLine(std::istream& file, std::string& line);

std::string trimmed(const std::string& text);
std::string lowered(std::string text);
std::vector<std::string> wordsOf(const std::string& text);

/** What a message shows of a file's text: up to 40 characters, those that can be printed. */
std::string shown(const std::string& text);

/** All of the text is a number, or none. */
template <typename Number>
std::optional<Number> numberOf(const char* begin, const char* end)
{
  begin += begin != end && *begin == '+' ? 1 : 0;
  Number number{};
  const auto result = std::from_chars(begin, end, number);
  return result.ec == std::errc() && result.ptr == end ? std::optional<Number>(number)
                                                       : std::nullopt;
}

/** The numbers of a field, divided by blanks. Throws ImageFileError that names the field if there
 * are not as many; 0: any number of them. */
std::vector<double> realsOf(const std::string& field, const std::string& text, std::size_t count);
std::vector<std::int64_t> wholesOf(
  const std::string& field, const std::string& text, std::size_t count);

/** The names of a pattern and numbers, "slice%03d.raw 1 20 1" and maybe a number of axes; empty if
 * the words are no pattern. Throws ImageFileError. */
std::vector<std::string> namesOfPattern(const std::vector<std::string>& words);

/** Of a file that a header names, from the folder of the header. */
std::string besideHeader(const std::string& header, const std::string& name);

} // namespace tetmarch

#endif
