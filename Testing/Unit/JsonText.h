// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Numbers of C++ as JSON, by which tests of the page's scripts check those of JavaScript
 */
#ifndef tetmarch_testing_JsonText_h
#define tetmarch_testing_JsonText_h

#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace tetmarch::testing
{
/// Doubles have 15 digits: those of the cases are written with fewer.
inline std::string json(const char* word) { return "\"" + std::string(word) + "\""; }
inline std::string json(const std::string& made) { return made; }
inline std::string json(bool is) { return is ? "true" : "false"; }
template <typename Number>
std::enable_if_t<std::is_arithmetic_v<Number>, std::string> json(Number x)
{
  std::ostringstream out;
  out.precision(std::is_same_v<Number, float> ? 9 : 15);
  out << x;
  return out.str();
}
template <typename List>
std::string json(const List& items, const typename List::value_type* = nullptr)
{
  std::string all;
  for (const auto& item : items)
  {
    all += (all.empty() ? "" : ",") + json(item);
  }
  return "[" + all + "]";
}
using Members = std::vector<std::pair<const char*, std::string>>;
inline std::string object(const Members& members)
{
  std::string all;
  for (const auto& [name, value] : members)
  {
    all += (all.empty() ? "" : ", ") + json(name) + ": " + value;
  }
  return "{" + all + "}";
}

/// A file of Testing/Web has this text. It is written anew if TETMARCH_WRITE_WEB_TABLES is set.
inline void expectStored(const std::string& file, const std::string& made, const char* script)
{
  const std::string name = TETMARCH_SOURCE_DIR "/Testing/Web/" + file;
  if (std::getenv("TETMARCH_WRITE_WEB_TABLES"))
  {
    std::ofstream(name) << made;
  }
  std::ifstream stream(name);
  const std::string stored{ std::istreambuf_iterator<char>(stream), {} };
  EXPECT_EQ(stored, made) << "Write " << name << " anew, and run Testing/Web/" << script << ".";
}
} // namespace tetmarch::testing

#endif
