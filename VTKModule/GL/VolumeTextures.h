// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A volume on the GPU: what of it is uploaded and bound. The passes know no more of it.
#ifndef TetMarchGLVolumeTextures_h
#define TetMarchGLVolumeTextures_h

#include "Budget/ResourceLimits.h"
#include "GL/Viewport.h"
#include "Variants/VariantKey.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

namespace tetmarch
{

struct View;

/** The entry points of shaders that march through the volume, or to it. */
enum class VolumePass
{
  March,
  MarchByCompute,
  Listed,
  ListedByCompute,
  Visits,
  Pick,
  VertexLight,
  VertexLightByCompute,
  BoundaryView
};

/** The file of its shader. The compiler warns of a pass that has none here. */
inline const char* fileOf(VolumePass pass)
{
  switch (pass)
  {
    case VolumePass::March:
      return "passes/march.frag.glsl";
    case VolumePass::MarchByCompute:
      return "passes/march.comp.glsl";
    case VolumePass::Listed:
      return "passes/listed.frag.glsl";
    case VolumePass::ListedByCompute:
      return "passes/listed.comp.glsl";
    case VolumePass::Visits:
      return "passes/visit.frag.glsl";
    case VolumePass::Pick:
      return "passes/pick.frag.glsl";
    case VolumePass::VertexLight:
      return "passes/vertex_light.frag.glsl";
    case VolumePass::VertexLightByCompute:
      return "passes/vertex_light.comp.glsl";
    case VolumePass::BoundaryView:
      return "passes/boundary_view.frag.glsl";
  }
  return nullptr;
}

class VolumeTextures
{
public:
  virtual ~VolumeTextures() = default;

  virtual std::vector<BufferSize> bufferSizes() const = 0;
  /** Whether all of the volume, as it is now, is on the GPU. */
  virtual bool isCurrent() const = 0;
  /** Upload the parts that have changed, and free unused ones. Returns an empty string or the
   * error. The next call tries a failed part again. */
  virtual std::string upload(vtkOpenGLRenderWindow* window) = 0;
  virtual void release(vtkWindow* window) = 0;
  virtual std::size_t bytes() const = 0;
  /** How many bytes were uploaded in all. */
  virtual std::int64_t uploadedBytes() const = 0;

  /** Set the bits of the key that say in how many textures the volume is. */
  virtual void setBits(VariantKey& key) const = 0;
  /** All that shaders of the key read of the volume. */
  virtual void bind(vtkShaderProgram* program, const VariantKey& key) = 0;
  virtual void unbind() = 0;

  /**
   * List where the rays of the viewport's pixels may enter, for passes of a key that has
   * EntryLists, unless it is listed already. It is called before these. Returns an empty string, or
   * what is wrong.
   */
  virtual std::string listEntries(vtkOpenGLRenderWindow* /*window*/, const VariantKey& /*key*/,
    const Viewport& /*viewport*/, const View& /*camera*/)
  {
    return {};
  }
  virtual void releaseEntries(vtkWindow* /*window*/) {}
  /** The part of a target of the viewport's size that includes all pixels with candidates. */
  virtual Viewport enteredPart(const VariantKey& /*key*/, const Viewport& target) const
  {
    return target;
  }
};

} // namespace tetmarch

#endif
