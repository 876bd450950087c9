// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A GL that takes only small textures of layers, as long as it lives
 */
#ifndef tetmarch_testing_SmallTextures_h
#define tetmarch_testing_SmallTextures_h

#include <limits>

namespace tetmarch::testing
{
struct TextureLimits
{
  int Layers = std::numeric_limits<int>::max();   ///< GL_MAX_ARRAY_TEXTURE_LAYERS
  long Texels = std::numeric_limits<long>::max(); ///< of a texture, as its proxy tells
  int Units = std::numeric_limits<int>::max();    ///< GL_MAX_TEXTURE_IMAGE_UNITS
  int Textures = std::numeric_limits<int>::max(); ///< there is no room for one more
};

/// One at a time. A limit that is above that of the GL changes nothing.
class SmallTextures
{
public:
  explicit SmallTextures(const TextureLimits& limits);
  ~SmallTextures();
  SmallTextures(const SmallTextures&) = delete;
  SmallTextures& operator=(const SmallTextures&) = delete;

  /// How many textures of layers were made.
  int made() const;
};
} // namespace tetmarch::testing

#endif
