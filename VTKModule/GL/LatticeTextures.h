// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A structured volume on the GPU: its values, and what its lattice needs beside them.
#ifndef TetMarchGLLatticeTextures_h
#define TetMarchGLLatticeTextures_h

#include "GL/ValueTextures.h"
#include "GL/VersionedBuffer.h"
#include "GL/VolumeTextures.h"

namespace tetmarch
{

class StructuredVolume;

class LatticeTextures : public VolumeTextures
{
public:
  /** The volume lives longer than the textures. */
  explicit LatticeTextures(const StructuredVolume& volume)
    : Volume(volume)
  {
  }

  /** The texture of values is no buffer; its sizes are checked where it is made. */
  std::vector<BufferSize> bufferSizes() const override;
  bool isCurrent() const override;
  /** What is new of the values, of uneven planes, of an octree, of hidden cells and of the empty
   * space. */
  std::string upload(vtkOpenGLRenderWindow* window) override;
  void release(vtkWindow* window) override;
  std::size_t bytes() const override;
  std::int64_t uploadedBytes() const override;

  void setBits(VariantKey& key) const override { this->Values.setBits(key); }
  /** The textures, and all else that shaders read of a lattice and of its light nodes. */
  void bind(vtkShaderProgram* program, const VariantKey& key) override;
  void unbind() override;

private:
  void bindExtra(vtkShaderProgram* program, const VariantKey& key);
  void bindValues(vtkShaderProgram* program, const VariantKey& key);
  void bindPlanes(vtkShaderProgram* program, const VariantKey& key);

  const StructuredVolume& Volume;
  ValueTextures Values; // of the first scalar and of those drawn with it
  Uploaded ValuesThere;
  VersionedBuffer Planes;
  VersionedBuffer Nodes;
  VersionedBuffer Hidden;
  VersionedBuffer Distances;
};

} // namespace tetmarch

#endif
