// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The values of a lattice on the GPU: of each scalar a texture; or, where the GL takes none that
// large, several textures with a slab of consecutive layers each.
#ifndef TetMarchGLValueTextures_h
#define TetMarchGLValueTextures_h

#include "GL/ArrayTexture.h"
#include "Variants/VariantKey.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace tetmarch
{

class ValueTextures
{
public:
  /** Replace the contents: width, height and number of layers, and the values of each scalar.
   * Nothing is left where that can't be done. Returns an empty string, or what is wrong and what
   * to do. */
  std::string upload(vtkOpenGLRenderWindow* window, const std::array<int, 3>& sizes,
    const std::vector<StoredValues>& values);

  /** Whether the values are in slabs, and in how many. */
  void setBits(VariantKey& key) const;
  /** Of a key without slabs: the texture of a scalar. */
  void bind(vtkShaderProgram* program, std::size_t scalar, const char* sampler);
  /** Of a key with slabs: all of them. */
  void bindSlabs(vtkShaderProgram* program, const VariantKey& key);
  void unbind();
  /** The window's context is current. */
  void release(vtkWindow* window);
  std::size_t bytes() const;

private:
  // How the layers of each scalar are shared among textures.
  struct Slabs
  {
    int Layers = 0;    // of each texture but the last one of a scalar, which may have fewer
    int PerScalar = 0; // textures
    int Scalars = 0;
  };
  static Slabs slabsFor(const std::array<int, 3>& sizes, const std::vector<StoredValues>& values);
  static std::string describeExcess(const std::array<int, 3>& sizes, const Slabs& slabs);

  // Of all scalars together, as many as Shaders/structured/slab_buffers.glsl reads.
  static constexpr int MostTextures = 8;
  std::array<ArrayTexture, MostTextures> Textures; // of the first scalar, then of the next one
  Slabs There;
};

} // namespace tetmarch

#endif
