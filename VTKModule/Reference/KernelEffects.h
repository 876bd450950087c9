// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What gradients and light read, as members of a kernel; part of KernelBody.h. Data that a scene
// lacks have values that change nothing.

const EffectData* Effects = nullptr;
Real gradientOpacityScale = 0;
int gradientOpacitySize = 2;

vec3 gradientOf(uint i) const
{
  const auto& g = Effects->Gradients[i];
  return vec3(Real(g[0]), Real(g[1]), Real(g[2]));
}
vec3 fetchGradient(uint vertex) const { return gradientOf(vertex); }
vec3 fetchCellGradient(uint tet) const { return gradientOf(tet); }
Real fetchGradientOpacity(int i) const
{
  return Effects->GradientOpacity.empty() ? Real(1) : Real(Effects->GradientOpacity.Values[i]);
}

void useEffects(const EffectData& effects)
{
  Effects = &effects;
  if (!effects.GradientOpacity.empty())
  {
    gradientOpacitySize = static_cast<int>(effects.GradientOpacity.Values.size());
    gradientOpacityScale = Real(effects.GradientOpacityScale);
  }
#if TETMARCH_SHADING
  useLights(effects.Lights);
#endif
}

#if TETMARCH_SHADING
const LightUniforms* Lights = nullptr;
/** Four a vertex; nullptr: every transmittance is 1. */
const Real* VertexLight = nullptr;
/** The exact light; nullptr: VertexLight is interpolated. */
const IncomingLight<Real>* Incoming = nullptr;
Real backSide = 1;
vec3 ambientColor{ 0, 0, 0 };
Real specularPower = 1;
Real scatteringBlending = 0;
Real gradientUnit = 1;
int lightCount = 0;

void useLights(const LightUniforms& lights)
{
  Lights = &lights;
  backSide = lights.TwoSided ? Real(1) : Real(0);
  // Without lights the volume has its own colour.
  ambientColor = lights.Sources.empty() ? vec3(1, 1, 1) : toVec3(lights.Ambient);
  specularPower = Real(lights.SpecularPower);
  scatteringBlending = Real(lights.ScatteringBlending);
  lightCount = static_cast<int>(lights.Sources.size());
}

static vec3 toVec3(const std::array<double, 3>& v)
{
  return vec3(Real(v[0]), Real(v[1]), Real(v[2]));
}
static vec4 toVec4(const std::array<double, 4>& v)
{
  return vec4(Real(v[0]), Real(v[1]), Real(v[2]), Real(v[3]));
}
static vec3 times(const std::array<double, 9>& m, vec3 v)
{
  const auto row = [&](int r)
  { return Real(m[3 * r]) * v.x + Real(m[3 * r + 1]) * v.y + Real(m[3 * r + 2]) * v.z; };
  return vec3(row(0), row(1), row(2));
}
vec3 toWorld(vec3 v) const { return times(Lights->WorldMatrix, v); }
vec3 toWorldNormal(vec3 gradient) const { return times(Lights->NormalMatrix, gradient); }
vec3 fetchLightDiffuse(int i) const { return toVec3(Lights->Sources[i].Diffuse); }
vec3 fetchLightSpecular(int i) const { return toVec3(Lights->Sources[i].Specular); }
vec4 fetchLightPlace(int i) const { return toVec4(Lights->Sources[i].Place); }
vec4 fetchLightAttenuation(int i) const { return toVec4(Lights->Sources[i].Attenuation); }
vec4 fetchLightCone(int i) const { return toVec4(Lights->Sources[i].Cone); }
bool isHeadlight(int i) const { return Lights->Sources[i].Headlight; }
Real fetchShadowStrength(int i) const { return Real(Lights->Sources[i].ShadowStrength); }
int fetchShadowChannel(int i) const { return Lights->Sources[i].ShadowChannel; }

vec4 fetchVertexLight(uint vertex) const
{
  const Real* v = VertexLight + 4 * std::size_t(vertex);
  return VertexLight ? vec4(v[0], v[1], v[2], v[3]) : vec4(1, 1, 1, 1);
}
bool hasExactLight() const { return Incoming != nullptr; }
vec4 exactIncoming(vec3 point) const { return Incoming->at(point); }
#endif
