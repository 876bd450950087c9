// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/LightBinding.h"

#include "GL/Uniforms.h"
#include "Scene/LightUniforms.h"
#include "Scene/VariantKey.h"

#include <vector>

namespace tetmarch
{
namespace
{

// All components of a member of the lamps, one lamp after the other.
template <std::size_t N>
std::vector<float> gather(
  const LightUniforms& lights, std::array<double, N> LightUniforms::Lamp::*member)
{
  std::vector<float> values;
  for (const LightUniforms::Lamp& lamp : lights.Lamps)
  {
    for (double x : lamp.*member)
    {
      values.push_back(static_cast<float>(x));
    }
  }
  return values;
}

void bindSources(vtkShaderProgram* program, const LightUniforms& lights, int count)
{
  std::vector<float> sources;
  for (const std::array<double, 4>& source : lights.ShadowSources)
  {
    for (double x : source)
    {
      sources.push_back(static_cast<float>(x));
    }
  }
  program->SetUniformi("shadowSourceCount", count);
  if (count > 0)
  {
    program->SetUniform4fv("shadowSource", count, sources.data());
  }
  program->SetUniformf("lightReach", static_cast<float>(lights.Reach));
}

} // namespace

void bindLights(vtkShaderProgram* program, const LightUniforms& lights, const VariantKey& key)
{
  using Lamp = LightUniforms::Lamp;
  const int count = static_cast<int>(lights.Lamps.size());
  program->SetUniformi("twoSided", lights.TwoSided ? 1 : 0);
  program->SetUniform3f("ambientColor", lights.Ambient.data());
  program->SetUniformf("specularPower", static_cast<float>(lights.SpecularPower));
  program->SetUniform3fv("lightDiffuse", count, gather(lights, &Lamp::Diffuse).data());
  program->SetUniform3fv("lightSpecular", count, gather(lights, &Lamp::Specular).data());
  if (!key.HeadlightOnly)
  {
    program->SetUniform4fv("lightPlace", count, gather(lights, &Lamp::Place).data());
  }
  if (!key.HeadlightOnly && !key.SingleLight)
  {
    std::vector<int> kinds;
    for (const Lamp& lamp : lights.Lamps)
    {
      kinds.push_back(lamp.Headlight ? 1 : 0);
    }
    program->SetUniformi("lightCount", count);
    program->SetUniform1iv("lightKind", count, kinds.data());
  }
  if (key.WorldLights)
  {
    setUniform(program, "worldMatrix", lights.WorldMatrix);
    setUniform(program, "normalMatrix", lights.NormalMatrix);
    program->SetUniform4fv("lightFading", count, gather(lights, &Lamp::Fading).data());
    program->SetUniform4fv("lightCone", count, gather(lights, &Lamp::Cone).data());
  }
  if (key.Scattering)
  {
    program->SetUniformf("scatteringBlending", static_cast<float>(lights.ScatteringBlending));
  }
  if (key.hasShadows())
  {
    std::vector<float> strengths;
    std::vector<int> channels;
    for (const Lamp& lamp : lights.Lamps)
    {
      strengths.push_back(static_cast<float>(lamp.ShadowStrength));
      channels.push_back(lamp.ShadowChannel);
    }
    program->SetUniform1fv("shadowStrength", count, strengths.data());
    program->SetUniform1iv("shadowChannel", count, channels.data());
  }
}

void bindSampledRays(vtkShaderProgram* program, const LightUniforms& lights)
{
  bindSources(program, lights, static_cast<int>(lights.ShadowSources.size()));
}

void bindVertexRays(vtkShaderProgram* program, const LightUniforms& lights, bool toLights)
{
  bindSources(program, lights, toLights ? static_cast<int>(lights.ShadowSources.size()) : 0);
  program->SetUniformi("occlusionDirectionCount", lights.OcclusionDirections);
  program->SetUniformf("occlusionRadius", static_cast<float>(lights.OcclusionRadius));
}

} // namespace tetmarch
