// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Conditions in shaders against what a preprocessor makes of them, and the files put together.
#include "Variants/ShaderConditions.h"
#include "Variants/ShaderSource.h"
#include "Variants/VariantKey.h"

#include <gtest/gtest.h>
#include <string>

namespace
{
using tetmarch::ShaderConditions;
using tetmarch::shaderSource;
using tetmarch::withFileNames;

const std::string Defines = "#define YES 1\n#define NO 0\n#define YESTERDAY 0\n"
                            "#define FIRST 0\n#define SECOND 0\n#define THIRD 0\n";

// What is left of the lines, without their breaks.
std::string left(const std::string& lines)
{
  ShaderConditions conditions(Defines);
  std::string text;
  std::size_t begin = 0;
  while (begin < lines.size())
  {
    const std::size_t end = lines.find('\n', begin);
    const std::string line = lines.substr(begin, end + 1 - begin);
    begin = end + 1;
    if (!conditions.take(line) && conditions.isActive())
    {
      text += line.substr(0, line.size() - 1);
    }
  }
  EXPECT_TRUE(conditions.isClosed());
  EXPECT_TRUE(conditions.isActive());
  return text;
}

bool isTrue(const std::string& expression)
{
  return left("#if " + expression + "\n1\n#else\n0\n#endif\n") == "1";
}

// What is wrong with an expression, or nothing.
std::string errorOf(const std::string& expression)
{
  ShaderConditions conditions(Defines);
  EXPECT_TRUE(conditions.take("#if " + expression + "\n"));
  return conditions.error();
}

// By a file for those that it includes; other words are the GL's own.
TEST(ShaderConditions, SymbolsOfFiles)
{
  EXPECT_EQ(left("#define TETMARCH_IT 1\n#if TETMARCH_IT\n1\n#endif\n"), "1");
  EXPECT_EQ(left("#define TETMARCH_IT 0\n#if TETMARCH_IT\n1\n#endif\n#define TETMARCH_IT 1\n"
                 "#if TETMARCH_IT\n2\n#endif\n"),
    "2");
  EXPECT_EQ(left("#define TETMARCH_IT 0\n#if NO\n#define TETMARCH_IT 1\n#endif\n"
                 "#if TETMARCH_IT\n1\n#else\n2\n#endif\n"),
    "2");
  EXPECT_EQ(left("#define IT 1\n#if IT\n1\n#endif\n"), "#define IT 1");
}

TEST(ShaderConditions, Expressions)
{
  EXPECT_TRUE(isTrue("YES"));
  EXPECT_FALSE(isTrue("NO"));
  EXPECT_FALSE(isTrue("!YES"));
  EXPECT_TRUE(isTrue("!NO"));
  EXPECT_TRUE(isTrue("! NO"));
  EXPECT_TRUE(isTrue("!!YES"));
  EXPECT_TRUE(isTrue("  YES  "));
  EXPECT_TRUE(isTrue("YES\r"));
  for (const bool p : { false, true })
  {
    for (const bool q : { false, true })
    {
      const std::string a = p ? "YES" : "NO";
      const std::string b = q ? "YES" : "NO";
      EXPECT_EQ(isTrue(a + " && " + b), p && q);
      EXPECT_EQ(isTrue(a + " || " + b), p || q);
      EXPECT_EQ(isTrue(a + "&&" + b), p && q);
      EXPECT_EQ(isTrue(a + " && !" + b), p && !q);
      EXPECT_EQ(isTrue("!" + a + " || " + b), !p || q);
      for (const bool r : { false, true })
      {
        const std::string c = r ? "YES" : "NO";
        EXPECT_EQ(isTrue(a + " || " + b + " && " + c), p || (q && r));
        EXPECT_EQ(isTrue(a + " && " + b + " || " + c), (p && q) || r);
        EXPECT_EQ(isTrue(a + " || " + b + " || " + c), p || q || r);
        EXPECT_EQ(isTrue(a + " && " + b + " && " + c), p && q && r);
        EXPECT_EQ(isTrue("(" + a + " || " + b + ") && " + c), (p || q) && r);
        EXPECT_EQ(isTrue(a + " && (" + b + " || !(" + c + "))"), p && (q || !r));
      }
    }
  }
}

TEST(ShaderConditions, NamesAreWhole)
{
  EXPECT_FALSE(isTrue("YESTERDAY"));
  EXPECT_EQ(errorOf("YE"), "unknown symbol YE");
  EXPECT_EQ(errorOf("ES"), "unknown symbol ES");
}

// A condition that cannot be settled is an error, and not false.
TEST(ShaderConditions, FaultsAreErrors)
{
  EXPECT_EQ(errorOf("YES"), "");
  EXPECT_EQ(errorOf("UNKNOWN"), "unknown symbol UNKNOWN");
  EXPECT_EQ(errorOf("!UNKNOWN"), "unknown symbol UNKNOWN");
  EXPECT_EQ(errorOf("YES || UNKNOWN"), "unknown symbol UNKNOWN");
  EXPECT_EQ(errorOf("NO && UNKNOWN"), "unknown symbol UNKNOWN");
  EXPECT_EQ(errorOf("(YES"), "missing )");
  EXPECT_EQ(errorOf("YES)"), "unexpected )\n");
  EXPECT_EQ(errorOf("YES NO"), "unexpected NO\n");
  EXPECT_EQ(errorOf("YES == NO"), "unexpected == NO\n");
  EXPECT_NE(errorOf("YES &&"), "");
  EXPECT_NE(errorOf(""), "");
  // Of the line that was taken last.
  ShaderConditions conditions(Defines);
  conditions.take("#if UNKNOWN\n");
  conditions.take("#else\n");
  EXPECT_EQ(conditions.error(), "");
}

TEST(ShaderConditions, SymbolsMayBeConditions)
{
  ShaderConditions conditions("#define LATER (FIRST || !SECOND)\n#define FIRST 0\n"
                              "#define SECOND (YES && NO)\n#define YES 1\n#define NO 0\n");
  EXPECT_TRUE(conditions.take("#if LATER\n"));
  EXPECT_TRUE(conditions.isActive());
  EXPECT_TRUE(conditions.take("#elif SECOND\n"));
  EXPECT_FALSE(conditions.isActive());
  EXPECT_EQ(conditions.error(), "");
}

TEST(ShaderConditions, OneBranch)
{
  const std::string text =
    "a\n#if FIRST\nb\n#elif SECOND\nc\n#elif THIRD\nd\n#else\ne\n#endif\nf\n";
  const auto with = [&](const std::string& name, std::string lines)
  {
    for (std::size_t at = lines.find(name); at != std::string::npos; at = lines.find(name))
    {
      lines.replace(at, name.size(), "YES");
    }
    return lines;
  };
  EXPECT_EQ(left(text), "aef");
  EXPECT_EQ(left(with("FIRST", text)), "abf");
  EXPECT_EQ(left(with("SECOND", text)), "acf");
  EXPECT_EQ(left(with("THIRD", text)), "adf");
  // The first that holds, and no other.
  EXPECT_EQ(left(with("SECOND", with("FIRST", text))), "abf");
  EXPECT_EQ(left(with("THIRD", with("FIRST", text))), "abf");
  EXPECT_EQ(left(with("THIRD", with("SECOND", text))), "acf");
  EXPECT_EQ(left("#if NO\na\n#elif NO\nb\n#endif\n"), "");
}

TEST(ShaderConditions, Nested)
{
  const auto nested = [](const std::string& outer, const std::string& inner)
  {
    return left("#if " + outer + "\na\n#if " + inner +
                "\nb\n#elif YES\nc\n#endif\nd\n#else\ne\n#if " + inner +
                "\nf\n#else\ng\n#endif\nh\n#endif\ni\n");
  };
  EXPECT_EQ(nested("YES", "YES"), "abdi");
  EXPECT_EQ(nested("YES", "NO"), "acdi");
  EXPECT_EQ(nested("NO", "YES"), "efhi");
  EXPECT_EQ(nested("NO", "NO"), "eghi");
}

TEST(ShaderConditions, OtherLinesAreText)
{
  EXPECT_EQ(left("#define NAME\n"), "#define NAME");
  EXPECT_EQ(left("#extension GL_X : require\n"), "#extension GL_X : require");
  EXPECT_EQ(left("// #if NO\n"), "// #if NO");
  EXPECT_EQ(left("if (x)\n"), "if (x)");
}

TEST(ShaderConditions, Unbalanced)
{
  ShaderConditions open(Defines);
  EXPECT_TRUE(open.take("#if YES\n"));
  EXPECT_TRUE(open.take("#if NO\n"));
  EXPECT_TRUE(open.take("#endif\n"));
  EXPECT_FALSE(open.isClosed());
  // Of no #if: left for the GL to complain of.
  for (const char* line : { "#elif YES\n", "#else\n", "#endif\n" })
  {
    ShaderConditions alone(Defines);
    EXPECT_FALSE(alone.take(line));
    EXPECT_TRUE(alone.isActive());
    EXPECT_TRUE(alone.isClosed());
  }
}

// #line names the line before the first, and compilers name lines in various ways.
TEST(ShaderSource, LinesAreThoseOfTheFile)
{
  const std::string text = shaderSource("march/ray_cast.glsl", Defines);
  EXPECT_EQ(text.find("//VTK::System::Dec\n#line "), 0u);
  const std::size_t digits = std::string("//VTK::System::Dec\n#line ").size();
  const int line = std::stoi(text.substr(digits)) + 1;
  EXPECT_EQ(withFileNames("0:" + std::to_string(line) + "(5): error: e"),
    "march/ray_cast.glsl:1(5): error: e");
  EXPECT_EQ(withFileNames("ERROR: 0:" + std::to_string(line + 8) + ": e\nand so on"),
    "ERROR: march/ray_cast.glsl:9: e\nand so on");
  EXPECT_EQ(
    withFileNames("0(" + std::to_string(line) + ") : error"), "march/ray_cast.glsl:1 : error");
  EXPECT_EQ(withFileNames("no place 7:12"), "no place 7:12");
}

// The symbols of the march's files are unknown without the defines of a key.
TEST(ShaderSource, UnknownSymbolsAreErrors)
{
  const std::string text = shaderSource("march/march.glsl");
  EXPECT_NE(text.find("\n#error unknown symbol TETMARCH_SAMPLED_SHADOWS\n"), std::string::npos);
  EXPECT_EQ(shaderSource("march/march.glsl", tetmarch::VariantKey().defines()).find("#error"),
    std::string::npos);
}

TEST(ShaderSource, UnknownFilesAreEmpty)
{
  EXPECT_EQ(shaderSource("nothing.glsl"), "//VTK::System::Dec\n");
}
} // namespace
