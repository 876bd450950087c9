// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/LightBinding.h"

#include "GL/Uniforms.h"
#include "Light/LightUniforms.h"
#include "Variants/VariantKey.h"

#include <vector>

namespace tetmarch
{
namespace
{

// All components of a member of all lights, one light after the other.
template <std::size_t N>
std::vector<float> gather(const std::vector<LightUniforms::Light>& sources,
  std::array<double, N> LightUniforms::Light::*member)
{
  std::vector<float> values;
  for (const LightUniforms::Light& source : sources)
  {
    for (double x : source.*member)
    {
      values.push_back(static_cast<float>(x));
    }
  }
  return values;
}

} // namespace

void bindLights(vtkShaderProgram* program, const LightUniforms& lights, const VariantKey& key)
{
  using Light = LightUniforms::Light;
  std::vector<Light> sources = lights.Sources;
  if (key.FewLights)
  {
    sources.resize(LightUniforms::FewLights); // by black ones
  }
  const int count = static_cast<int>(sources.size());
  program->SetUniformf("givenBackSide", lights.TwoSided ? 1 : 0);
  program->SetUniform3f("givenAmbient", lights.Ambient.data());
  program->SetUniformf("givenSpecularPower", static_cast<float>(lights.SpecularPower));
  program->SetUniform3fv("lightDiffuse", count, gather(sources, &Light::Diffuse).data());
  program->SetUniform3fv("lightSpecular", count, gather(sources, &Light::Specular).data());
  if (!key.HeadlightOnly)
  {
    program->SetUniform4fv("lightPlace", count, gather(sources, &Light::Place).data());
  }
  if (!key.HeadlightOnly && !key.SingleLight)
  {
    std::vector<float> kinds;
    for (const Light& source : sources)
    {
      kinds.push_back(source.Headlight ? 1.0f : 0.0f);
    }
    program->SetUniformi("lightCount", count);
    program->SetUniform1fv("lightKind", count, kinds.data());
  }
  if (key.WorldLights)
  {
    setUniform(program, "worldMatrix", lights.WorldMatrix);
    setUniform(program, "normalMatrix", lights.NormalMatrix);
    program->SetUniform4fv("lightAttenuation", count, gather(sources, &Light::Attenuation).data());
    program->SetUniform4fv("lightCone", count, gather(sources, &Light::Cone).data());
  }
  if (key.LightTolerance)
  {
    program->SetUniformf("lightTolerance", static_cast<float>(lights.Tolerance));
  }
  if (key.Scattering)
  {
    program->SetUniformf("scatteringBlending", static_cast<float>(lights.ScatteringBlending));
  }
  if (key.hasShadows())
  {
    std::vector<float> strengths;
    std::vector<int> channels;
    for (const Light& source : sources)
    {
      strengths.push_back(static_cast<float>(source.ShadowStrength));
      channels.push_back(source.ShadowChannel);
    }
    program->SetUniform1fv("shadowStrength", count, strengths.data());
    program->SetUniform1iv("shadowChannel", count, channels.data());
  }
}

void bindLightRays(vtkShaderProgram* program, const LightUniforms& lights, const VariantKey& key)
{
  std::vector<float> sources;
  for (const std::array<double, 4>& source : lights.ShadowSources)
  {
    for (double x : source)
    {
      sources.push_back(static_cast<float>(x));
    }
  }
  const int count = static_cast<int>(lights.ShadowSources.size());
  program->SetUniformi("shadowSourceCount", count);
  if (count > 0)
  {
    program->SetUniform4fv("shadowSource", count, sources.data());
  }
  program->SetUniformf("lightReach", static_cast<float>(lights.Reach));
  if (key.SampledShadows && key.LightTolerance)
  {
    program->SetUniformi("expectedLightTurns", lights.TurnsOfSample);
  }
  if (!key.SampledShadows || key.samplesOcclusion())
  {
    program->SetUniformi("occlusionDirectionCount", lights.OcclusionDirections);
    program->SetUniformf("occlusionRadius", static_cast<float>(lights.OcclusionRadius));
  }
}

} // namespace tetmarch
