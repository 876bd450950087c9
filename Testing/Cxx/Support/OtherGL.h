// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A GL that answers as another one does, as long as it lives
 */
#ifndef tetmarch_testing_OtherGL_h
#define tetmarch_testing_OtherGL_h

#include "GLPointers.h"

#include <map>
#include <string>
#include <vector>

namespace tetmarch::testing
{
struct GLAnswers
{
  std::map<GLenum, std::string> Strings;        ///< of glGetString()
  std::map<GLenum, GLint> Integers;             ///< of glGetIntegerv()
  std::vector<GLenum> RefusedIntegers;          ///< it has an error for these, and no value
  std::vector<GLenum> RefusedLevelParameters{}; ///< the same of glGetTexLevelParameteriv()
  bool HasDepthTextures = true;                 ///< else such a proxy is an error
};

/// One at a time.
class OtherGL
{
public:
  explicit OtherGL(const GLAnswers& answers);
  ~OtherGL();
  OtherGL(const OtherGL&) = delete;
  OtherGL& operator=(const OtherGL&) = delete;

  /// The texels of the largest buffer that has become a texture of the format, or of any.
  std::size_t mostTexelsMade(GLenum format) const;
  std::size_t mostTexelsMade() const;
  /// How often a query was refused.
  int refusals() const;
};
} // namespace tetmarch::testing

#endif
