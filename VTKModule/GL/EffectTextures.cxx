// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/EffectTextures.h"

#include "GL/ErrorQueue.h"
#include "Mesh/HalfFloats.h"
#include "View/BlueNoise.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <limits>

namespace tetmarch
{

std::string EffectTextures::update(
  vtkOpenGLRenderWindow* window, const EffectStage& stage, const VariantKey& key)
{
  const EffectData& data = stage.data();
  const bool stored = key.hasStoredGradients();
  this->GradientUnit = stored ? this->GradientUnit : 1;
  std::string error = this->Gradients.update(window, stored, stage.gradientsVersion(),
    [&](CellBuffer& buffer)
    {
      const PackedGradients packed = packGradients(data.Gradients);
      this->GradientUnit = packed.Unit;
      return buffer.upload(window, TexelFormat::RGBA16F, packed.Texels.size(),
        [&](std::size_t begin, std::size_t) { return &packed.Texels[begin]; });
    });
  if (error.empty())
  {
    error =
      this->GradientOpacity.update(window, key.GradientOpacity, stage.gradientOpacityVersion(),
        [&](TextureBuffer& buffer)
        {
          const std::vector<float>& values = data.GradientOpacity.Values;
          return buffer.upload(window, TexelFormat::R32F, values.data(), values.size());
        });
  }
  if (error.empty())
  {
    // The nodes of a lattice follow from their numbers.
    const bool started = key.hasVertexLight() && !key.Structured;
    error = this->Starts.update(window, started, stage.startsVersion(),
      [&](TextureBuffer& buffer)
      {
        const auto& starts = data.VertexStarts;
        return buffer.upload(window, TexelFormat::RGBA32UI, starts.data(), starts.size());
      });
  }
  if (error.empty())
  {
    const bool atVertices = key.OpaqueShadows && !key.SampledShadows;
    error = this->OpaqueShadows.update(window, atVertices, stage.opaqueShadowsVersion(),
      [&](TextureBuffer& buffer)
      {
        const auto& shadowed = data.ShadowedVertices;
        return buffer.upload(window, TexelFormat::R8UI, shadowed.data(), shadowed.size());
      });
  }
  if (error.empty())
  {
    error = this->Surfaces.update(window, key.samplesSurfaces(), data.Opaque.version(),
      [&](TextureBuffer& buffer)
      {
        const auto texels = data.Opaque.texels();
        return buffer.upload(window, TexelFormat::RGBA32F, texels.data(), texels.size());
      });
  }
  return error.empty() ? this->updateJitter(window, key.SampledShadows || key.PointSampled) : error;
}

void EffectTextures::releaseJitter(vtkWindow* window)
{
  if (this->Jitter)
  {
    this->Jitter->ReleaseGraphicsResources(window);
    this->Jitter = nullptr;
  }
}

std::string EffectTextures::updateJitter(vtkOpenGLRenderWindow* window, bool needed)
{
  if (!needed)
  {
    this->releaseJitter(window);
  }
  if (needed && !this->Jitter)
  {
    std::vector<float> tile = blueNoiseTile();
    clearErrors();
    this->Jitter = vtkSmartPointer<vtkTextureObject>::New();
    this->Jitter->SetContext(window);
    this->Jitter->SetMinificationFilter(vtkTextureObject::Nearest);
    this->Jitter->SetMagnificationFilter(vtkTextureObject::Nearest);
    this->Jitter->Create2DFromRaw(BlueNoiseSide, BlueNoiseSide, 1, VTK_FLOAT, tile.data());
    if (!hasRoom(this->Jitter))
    {
      this->releaseJitter(window);
      return "The GPU has no room for a texture of 64 x 64 numbers. Close what else uses it.";
    }
  }
  return {};
}

void EffectTextures::bind(vtkShaderProgram* program, const EffectData& data, const VariantKey& key)
{
  if (key.hasStoredGradients())
  {
    this->Gradients.bind(program, "gradientBuffer", "secondGradientBuffer");
  }
  if (key.Scattering)
  {
    program->SetUniformf("gradientUnit", static_cast<float>(this->GradientUnit));
  }
  if (key.GradientOpacity)
  {
    this->GradientOpacity.bind(program, "gradientOpacityBuffer");
    program->SetUniformi(
      "gradientOpacitySize", static_cast<int>(data.GradientOpacity.Values.size()));
    program->SetUniformf(
      "gradientOpacityScale", static_cast<float>(data.GradientOpacityScale * this->GradientUnit));
  }
}

void EffectTextures::bindVertexRays(vtkShaderProgram* program, const VariantKey& key)
{
  if (!key.Structured)
  {
    this->Starts.bind(program, "vertexStartBuffer");
  }
  if (key.OpaqueShadows)
  {
    this->OpaqueShadows.bind(program, "opaqueShadowBuffer");
  }
}

void EffectTextures::bindSurfaces(vtkShaderProgram* program, const EffectData& data)
{
  this->Surfaces.bind(program, "opaqueSurfaceBuffer");
  program->SetUniformi("opaqueSurfaceCount", static_cast<int>(data.Opaque.size()));
  program->SetUniformf("opaqueReach", static_cast<float>(std::min(data.Lights.OpaqueReach,
                                        double(std::numeric_limits<float>::max()))));
}

void EffectTextures::bindJitter(vtkShaderProgram* program)
{
  this->Jitter->Activate();
  program->SetUniformi("jitterTexture", this->Jitter->GetTextureUnit());
}

void EffectTextures::unbind()
{
  this->Gradients.unbind();
  this->GradientOpacity.unbind();
  this->Starts.unbind();
  this->OpaqueShadows.unbind();
  this->Surfaces.unbind();
  if (this->Jitter)
  {
    this->Jitter->Deactivate();
  }
}

void EffectTextures::release(vtkWindow* window)
{
  this->Gradients.release(window);
  this->GradientOpacity.release(window);
  this->Starts.release(window);
  this->OpaqueShadows.release(window);
  this->Surfaces.release(window);
  this->releaseJitter(window);
}

std::size_t EffectTextures::bytes() const
{
  return this->Gradients.bytes() + this->GradientOpacity.bytes() + this->Starts.bytes() +
         this->OpaqueShadows.bytes() + this->Surfaces.bytes() +
         (this->Jitter ? sizeof(float) * BlueNoiseSide * BlueNoiseSide : 0);
}

std::int64_t EffectTextures::uploadedBytes() const
{
  return this->Gradients.uploadedBytes() + this->GradientOpacity.uploadedBytes() +
         this->Starts.uploadedBytes() + this->OpaqueShadows.uploadedBytes() +
         this->Surfaces.uploadedBytes();
}

} // namespace tetmarch
