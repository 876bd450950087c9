// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The data of the effects on the GPU, as far as the variant needs it.
#ifndef TetMarchGLEffectTextures_h
#define TetMarchGLEffectTextures_h

#include "GL/CellBuffer.h"
#include "GL/VersionedBuffer.h"
#include "Light/EffectStage.h"
#include "Variants/VariantKey.h"

#include "vtkSmartPointer.h"

#include <string>

namespace tetmarch
{

class EffectTextures
{
public:
  /** Uploads what has changed, and frees what the key does not use. Returns an empty string, or
   * what is wrong. */
  std::string update(
    vtkOpenGLRenderWindow* window, const EffectStage& stage, const VariantKey& key);
  /** What Shaders/light/gradient_buffers.glsl declares. */
  void bind(vtkShaderProgram* program, const EffectData& data, const VariantKey& key);
  /** What Shaders/light/vertex_ray_buffers.glsl declares. */
  void bindVertexRays(vtkShaderProgram* program, const VariantKey& key);
  /** What Shaders/light/opaque_surface_buffers.glsl declares. */
  void bindSurfaces(vtkShaderProgram* program, const EffectData& data);
  /** For samples along rays. */
  void bindJitter(vtkShaderProgram* program);
  void unbind();
  void release(vtkWindow* window);
  std::size_t bytes() const;
  /** How many bytes were uploaded in all. */
  std::int64_t uploadedBytes() const;

private:
  std::string updateJitter(vtkOpenGLRenderWindow* window, bool needed);
  void releaseJitter(vtkWindow* window);

  Versioned<CellBuffer> Gradients; // of vertices or of cells
  VersionedBuffer GradientOpacity;
  VersionedBuffer Starts;
  VersionedBuffer OpaqueShadows; // of vertices
  VersionedBuffer Surfaces;      // that cast shadows
  vtkSmartPointer<vtkTextureObject> Jitter;
  double GradientUnit = 1;
};

} // namespace tetmarch

#endif
