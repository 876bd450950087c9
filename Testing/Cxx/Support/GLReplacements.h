// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Puts other functions in the place of those of the GL
 *
 * Those that VTK calls by pointers (GLPointers.h) are replaced there; functions of GL 1.1 that have
 * none where GLFunctions.h forwards them.
 */
#ifndef tetmarch_testing_GLReplacements_h
#define tetmarch_testing_GLReplacements_h

#include "GLPointers.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

#if TETMARCH_GL_1_IS_LINKED
#include "GLFunctions.h"
#endif

namespace tetmarch::testing
{
/// The replacements of one Owner, a class that has at most one object at a time. Each Owner has a
/// loader of its own, because GLFunctions.h looks functions up again when the loader changes.
template <typename Owner>
class GLReplacements
{
public:
  /// `original` becomes what the pointer was.
  template <typename Function>
  void replace(Function& pointer, Function replacement, Function& original)
  {
    original = pointer;
    pointer = replacement;
    this->Restorers.push_back([&pointer, before = original] { pointer = before; });
  }

#if TETMARCH_GL_1_IS_LINKED
  /// The same of a function of GL 1.1.
  template <typename Function>
  void replaceLinked(const char* name, Function replacement, Function& original)
  {
    if (Linked.empty())
    {
      Before = SetGLFunctionLoader(&find);
    }
    original = reinterpret_cast<Function>(Before(name));
    Linked[name] = reinterpret_cast<GLFunction>(replacement);
  }
#endif

  /// All is as it was.
  void restore()
  {
    for (const std::function<void()>& restorer : this->Restorers)
    {
      restorer();
    }
    this->Restorers.clear();
#if TETMARCH_GL_1_IS_LINKED
    if (!Linked.empty())
    {
      SetGLFunctionLoader(Before);
      Linked.clear();
    }
#endif
  }

private:
  std::vector<std::function<void()>> Restorers;

#if TETMARCH_GL_1_IS_LINKED
  static GLFunction find(const char* name)
  {
    const auto replacement = Linked.find(name);
    return replacement == Linked.end() ? Before(name) : replacement->second;
  }

  static inline GLFunctionLoader Before = nullptr;
  static inline std::map<std::string, GLFunction> Linked;
#endif
};
} // namespace tetmarch::testing

// Replaces glTexBuffer by `replacement` if the name is TexBuffer; _1 is for functions of GL 1.1.
#define TETMARCH_REPLACE_GL(replacements, name, replacement)                                       \
  (replacements).replace(TETMARCH_GL_POINTER(name), &(replacement), name)
#if TETMARCH_GL_1_IS_LINKED
#define TETMARCH_REPLACE_GL_1(replacements, name, replacement)                                     \
  (replacements).replaceLinked("gl" #name, &(replacement), name)
#else
#define TETMARCH_REPLACE_GL_1 TETMARCH_REPLACE_GL
#endif

#endif
