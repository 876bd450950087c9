// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What rays towards the light read, as members of a kernel; part of KernelBody.h.

const LightUniforms* Lights = nullptr;
const View* Camera = nullptr;
int shadowSourceCount = 0;
int occlusionDirectionCount = 0;
Real occlusionRadius = 0;
Real lightReach = 0;

void useLightRays(const LightUniforms& lights, const View& view)
{
  Lights = &lights;
  Camera = &view;
  shadowSourceCount = static_cast<int>(lights.ShadowSources.size());
  occlusionDirectionCount = lights.OcclusionDirections;
  occlusionRadius = Real(lights.OcclusionRadius);
  lightReach = Real(lights.Reach);
  clippingPlaneCount = lights.ThroughCuts ? clippingPlaneCount : 0;
}

vec4 fetchShadowSource(int i) const
{
  // The shader reads a source even if there is none, and does not use it.
  const auto& v =
    Lights->ShadowSources.empty()
      ? std::array<double, 4>{}
      : Lights->ShadowSources[std::min<std::size_t>(i, Lights->ShadowSources.size() - 1)];
  return vec4(Real(v[0]), Real(v[1]), Real(v[2]), Real(v[3]));
}
Real thicknessPerDepthAlong(vec3 direction) const
{
  return thicknessPerDepth<Real>(*Camera, { direction.x, direction.y, direction.z });
}
uvec4 fetchVertexStart(uint vertex) const
{
  const auto& v = Effects->VertexStarts[vertex];
  return uvec4(v[0], v[1], v[2], v[3]);
}
uint fetchOpaqueShadows(uint vertex) const
{
  return Effects->ShadowedVertices.empty() ? 0u : Effects->ShadowedVertices[vertex];
}
