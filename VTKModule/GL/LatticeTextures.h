// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A structured volume on the GPU: its values, and what its lattice needs beside them.
#ifndef TetMarchGLLatticeTextures_h
#define TetMarchGLLatticeTextures_h

#include "GL/ValueTextures.h"
#include "GL/VersionedBuffer.h"
#include "Rays/RaySamples.h"
#include "Structured/StructuredVolume.h"
#include "Variants/VariantKey.h"

#include <string>

namespace tetmarch
{

/** What of a structured volume rays leap over, and the version of that. */
struct VersionedDistances
{
  const BlockDistances& Empty;
  bool Used;
  Fingerprint Version;
};

class LatticeTextures
{
public:
  /** Whether all of the volume, as it is now, is on the GPU. */
  bool isCurrent(const StructuredVolume& volume, const VersionedDistances& distances) const;
  /** What is new of the values, of uneven planes, of hidden cells and of the distances; what is not
   * needed is freed. Returns an empty string, or what is wrong and what to do. */
  std::string upload(vtkOpenGLRenderWindow* window, const StructuredVolume& volume,
    const VersionedDistances& distances);

  /** In how many textures the values are. */
  void setBits(VariantKey& key) const { this->Values.setBits(key); }
  /** The textures, and all else that shaders read of a lattice and of its light nodes. */
  void bind(vtkShaderProgram* program, const VariantKey& key, const StructuredVolume& volume,
    const BlockDistances& empty, const RaySamples& samples);
  void unbind();
  void release(vtkWindow* window);
  std::size_t bytes() const;
  /** How many bytes were uploaded in all. */
  std::int64_t uploadedBytes() const;

private:
  void bindFurther(
    vtkShaderProgram* program, const VariantKey& key, const StructuredVolume& volume);
  void bindValues(vtkShaderProgram* program, const VariantKey& key, const StructuredVolume& volume);
  void bindPlanes(vtkShaderProgram* program, const VariantKey& key, const Lattice& lattice);

  ValueTextures Values; // of the first scalar and of those drawn with it
  Uploaded ValuesThere;
  VersionedBuffer Planes;
  VersionedBuffer Hidden;
  VersionedBuffer Distances;
};

} // namespace tetmarch

#endif
