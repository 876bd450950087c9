// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// No value that is not a number keeps a loop of the shaders alive: compilers may assume that there
// is none, and turn comparisons round. So each loop ends by a count of its turns.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace
{
namespace fs = std::filesystem;

// Loops that end for another reason, which is not about floats either.
const std::map<std::string, const char*> Others{
  { "high - low > 1", "each turn halves the distance" },
  { "node >= 0 || face < end", "each node of a tree is visited once" },
  { "node > 0 || triangle < end", "each node of a tree is visited once" },
};

struct Loop
{
  std::string Place;
  std::string Condition;
  const std::string* Text; // of its file
};

class ShaderLoops : public testing::Test
{
protected:
  ShaderLoops()
  {
    for (const auto& entry : fs::recursive_directory_iterator(TETMARCH_SHADER_DIR))
    {
      if (entry.path().extension() == ".glsl")
      {
        std::ifstream file(entry.path());
        const std::string text{ std::istreambuf_iterator<char>(file), {} };
        this->Texts[entry.path().filename().string()] =
          std::regex_replace(text, std::regex("//[^\n]*"), "");
      }
    }
    for (const auto& [name, text] : this->Texts)
    {
      this->declare(text, std::regex("\\bu?int (\\w+)"), this->Integers);
      this->declare(text, std::regex("\\b(?:real|float) (\\w+)"), this->Floats);
      this->addLoops(name, text);
    }
  }

  static void declare(
    const std::string& text, const std::regex& declaration, std::set<std::string>& names)
  {
    for (std::sregex_iterator match(text.begin(), text.end(), declaration), none; match != none;
         ++match)
    {
      names.insert((*match)[1]);
    }
  }

  void addLoops(const std::string& name, const std::string& text)
  {
    const std::regex begin("\\b(while|for) \\(");
    for (std::sregex_iterator match(text.begin(), text.end(), begin), none; match != none; ++match)
    {
      const std::size_t from = match->position() + match->length();
      std::size_t to = from;
      for (int depth = 1; depth > 0; ++to)
      {
        depth += text[to] == '(' ? 1 : (text[to] == ')' ? -1 : 0);
      }
      std::string condition = text.substr(from, to - 1 - from);
      if ((*match)[1] == "for")
      {
        const std::size_t first = condition.find(';');
        condition = condition.substr(first + 2, condition.find(';', first + 1) - first - 2);
      }
      std::smatch set;
      const std::regex last("\\b" + condition + " = ([^;]* && [^;]*);");
      if (std::regex_match(condition, std::regex("\\w+")) && std::regex_search(text, set, last))
      {
        condition = set[1]; // what the loop sets it to
      }
      condition = std::regex_replace(condition, std::regex("\\s+"), " ");
      this->Loops.push_back({ name + ": " + condition, condition, &text });
    }
  }

  // Declared in this file, or in another one but nowhere as a float; or a constant.
  bool isInteger(const std::string& name, const std::string& text) const
  {
    const bool constant = std::none_of(
      name.begin(), name.end(), [](unsigned char letter) { return std::islower(letter) != 0; });
    const bool here = std::regex_search(text, std::regex("\\bint " + name + "\\b"));
    const bool elsewhere = this->Integers.count(name) == 1 && this->Floats.count(name) == 0;
    return constant || here || elsewhere;
  }

  // A comparison of integers, whose left side the file counts up or down.
  bool counts(const std::string& part, const std::string& text) const
  {
    std::smatch match;
    if (!std::regex_match(part, match, std::regex(" ?(?:\\w+\\.)*(\\w+) (<|<=|>) ([^|]+?) ?")))
    {
      return false;
    }
    const std::string counter = match[1], bound = match[3];
    const std::regex word("\\b[a-zA-Z_]\\w*\\b");
    std::set<std::string> words{ counter };
    for (std::sregex_iterator name(bound.begin(), bound.end(), word), none; name != none; ++name)
    {
      words.insert(name->str());
    }
    const bool integers = std::all_of(words.begin(), words.end(),
      [&](const std::string& name) { return this->isInteger(name, text); });
    return integers && std::regex_search(text, std::regex("\\b" + counter + " = [a-z.]*" + counter +
                                                          " [-+]|\\+\\+" + counter));
  }

  std::map<std::string, std::string> Texts; // by file
  std::set<std::string> Integers;
  std::set<std::string> Floats;
  std::vector<Loop> Loops;
};

TEST_F(ShaderLoops, EndByACount)
{
  std::set<std::string> others;
  for (const Loop& loop : this->Loops)
  {
    const std::regex both("&&");
    const std::string& condition = loop.Condition;
    const bool bounded =
      std::any_of(std::sregex_token_iterator(condition.begin(), condition.end(), both, -1),
        std::sregex_token_iterator(),
        [&](const std::string& part) { return this->counts(part, *loop.Text); });
    if (Others.count(condition) == 1)
    {
      others.insert(condition);
    }
    else
    {
      EXPECT_TRUE(bounded) << loop.Place;
    }
  }
  EXPECT_EQ(others.size(), Others.size());
  EXPECT_GT(this->Loops.size(), 30u);
}

// A check of the check.
TEST_F(ShaderLoops, OfFloatsAreNotCounted)
{
  const std::string text = "int turns = 0; turns = turns + 1;";
  EXPECT_TRUE(this->counts("turns < mostSteps", text));
  for (const char* condition : { "pending", "end < depthEnd", "pull <= real(1)", "!picked",
         "traversal.entry.depth < depthEnd", "next.face >= 0" })
  {
    EXPECT_FALSE(this->counts(condition, text)) << condition;
  }
}
} // namespace
