// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which words a shader's text has for which variants, and for no others.
#ifndef tetmarch_testing_ShaderFeatures_h
#define tetmarch_testing_ShaderFeatures_h

#include "Variants/VariantKey.h"

#include <vector>

namespace tetmarch::testing
{
/// The entry points that march.
enum class MarchShader
{
  Picture,       // passes/march.frag.glsl
  LightAtVertex, // passes/vertex_light.frag.glsl
  Pick           // passes/pick.frag.glsl
};

struct ShaderFeature
{
  const char* Name;
  bool (*IsOn)(const VariantKey& key, MarchShader shader);
  /// Divided by blanks: functions, uniforms and whatever else has a name of its own.
  const char* Words;
};

/// All features that not every variant has.
const std::vector<ShaderFeature>& shaderFeatures();
/// Among them: what rays march through, and gradients and light.
std::vector<ShaderFeature> featuresOfVolumes();
std::vector<ShaderFeature> featuresOfLight();

inline bool isPicture(MarchShader shader) { return shader == MarchShader::Picture; }
inline bool isLight(MarchShader shader) { return shader == MarchShader::LightAtVertex; }
inline bool isPick(MarchShader shader) { return shader == MarchShader::Pick; }
/// Gathers what the picture shows. Rays from the nodes of a lattice towards lights do so, too.
inline bool gathers(const VariantKey& key, MarchShader shader)
{
  return !isLight(shader) || key.Structured;
}
/// Marches rays towards lights.
inline bool followsLight(const VariantKey& key, MarchShader shader)
{
  return isLight(shader) || key.SampledShadows;
}
/// Cuts trilinear cells evenly instead of by the error.
inline bool cutsEvenly(const VariantKey& key)
{
  return key.Structured && key.PointScalars && key.isComposite() && !key.Adaptive &&
         !key.hasComponents() && !key.PointSampled;
}
/// Bounds what the steps of the integrals of transfer functions put a composite off.
inline bool hasStepError(const VariantKey& key)
{
  return key.Diagnostics && key.isComposite() && key.PointScalars && !key.PointSampled;
}
inline bool isIsosurfaces(const VariantKey& key) { return key.Blend == BlendGroup::Isosurfaces; }

/// Functions, divided by blanks, that some variants have without using them: those that stay beside
/// what does use them, in one file, and two that VTK's own text calls. What they lead to is never
/// more than arithmetic and the mesh's or tables' buffers.
extern const char* const UnusedInSome;
} // namespace tetmarch::testing

#endif
