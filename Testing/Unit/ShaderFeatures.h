// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which words a shader's text has for which variants, and for no others.
#ifndef tetmarch_testing_ShaderFeatures_h
#define tetmarch_testing_ShaderFeatures_h

#include "Variants/VariantKey.h"

#include <string>
#include <vector>

namespace tetmarch::testing
{
/// The entry points that go through the mesh.
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

/// Functions, divided by blanks, that some variants have without using them: those that stay beside
/// what does use them, in one file, and two that VTK's own text calls. What they lead to is never
/// more than arithmetic and the mesh's or tables' buffers.
extern const char* const UnusedInSome;
} // namespace tetmarch::testing

#endif
