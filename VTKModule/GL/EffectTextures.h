// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What gradients and light read, on the GPU: only what the variant needs.
#ifndef TetMarchGLEffectTextures_h
#define TetMarchGLEffectTextures_h

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
  void bindVertexRays(vtkShaderProgram* program, const EffectData& data, const VariantKey& key);
  /** For samples along rays. */
  void bindJitter(vtkShaderProgram* program);
  void unbind();
  void release(vtkWindow* window);
  std::size_t bytes() const;
  /** Since the object was made. */
  std::int64_t uploadedBytes() const;

private:
  std::string updateJitter(vtkOpenGLRenderWindow* window, bool needed);
  void releaseJitter(vtkWindow* window);

  VersionedBuffer Gradients;
  VersionedBuffer GradientOpacity;
  VersionedBuffer Starts;
  VersionedBuffer OpaqueShadows;
  vtkSmartPointer<vtkTextureObject> Jitter;
  double GradientUnit = 1;
};

} // namespace tetmarch

#endif
