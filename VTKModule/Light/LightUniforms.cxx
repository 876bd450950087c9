// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Light/LightUniforms.h"

#include "Geometry/VolumeFrame.h"

#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetmarch
{
namespace
{

using Triple = std::array<double, 3>;
using Matrix = std::array<double, 9>;

Triple times(const Matrix& m, const Triple& v)
{
  Triple result{};
  for (int r = 0; r < 3; ++r)
  {
    result[r] = m[3 * r] * v[0] + m[3 * r + 1] * v[1] + m[3 * r + 2] * v[2];
  }
  return result;
}

Triple unit(Triple v)
{
  const double length = std::hypot(v[0], v[1], v[2]);
  for (double& x : v)
  {
    x = length > 0 ? x / length : 0;
  }
  return v;
}

double greatest(const Matrix& m)
{
  double most = 0;
  for (double x : m)
  {
    most = std::max(most, std::abs(x));
  }
  return most;
}

Matrix scaled(Matrix m, double factor)
{
  for (double& x : m)
  {
    x *= factor;
  }
  return m;
}

// From the normalised frame to the world, both with the volume's centre as origin.
struct WorldTransform
{
  Matrix ToWorld{};
  Matrix FromWorld{};
  Triple Center{};         // in the world
  double Unit = 1;         // of the world's coordinates in the shader
  bool KeepsAngles = true; // only rotation, reflection and uniform scaling
};

// Whether columns are orthogonal and of equal length to within float precision.
bool keepsAngles(const Matrix& m)
{
  double products[3][3];
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      products[i][k] = m[i] * m[k] + m[3 + i] * m[3 + k] + m[6 + i] * m[6 + k];
    }
  }
  double apart = 0;
  for (int i = 0; i < 3; ++i)
  {
    const int next = (i + 1) % 3;
    apart = std::max(apart, std::abs(products[i][i] - products[next][next]));
    apart = std::max(apart, std::abs(products[i][next]));
  }
  return apart <= 1e-6 * products[0][0];
}

WorldTransform worldTransform(vtkVolume* volume, const VolumeFrame& frame)
{
  WorldTransform world;
  vtkMatrix4x4* matrix = volume->GetMatrix();
  double rows[3][3];
  double inverse[3][3];
  for (int r = 0; r < 3; ++r)
  {
    world.Center[r] = matrix->GetElement(r, 3);
    for (int c = 0; c < 3; ++c)
    {
      rows[r][c] = matrix->GetElement(r, c) * frame.Radius;
      world.ToWorld[3 * r + c] = rows[r][c];
      world.Center[r] += matrix->GetElement(r, c) * frame.Center[c];
    }
  }
  vtkMath::Invert3x3(rows, inverse);
  for (int i = 0; i < 9; ++i)
  {
    world.FromWorld[i] = inverse[i / 3][i % 3];
  }
  const double most = greatest(world.ToWorld);
  world.Unit = most > 0 ? most : 1;
  world.KeepsAngles = keepsAngles(world.ToWorld);
  return world;
}

Matrix transposed(const Matrix& m)
{
  return { { m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8] } };
}

// The unit vector to a directional light, in the normalised frame.
Triple wayOf(const LightSource& light, const WorldTransform& world)
{
  return unit(
    times(world.FromWorld, { { -light.Direction[0], -light.Direction[1], -light.Direction[2] } }));
}

LightUniforms::Light lightSourceOf(
  const LightSource& light, const Lighting& lighting, const WorldTransform& world, bool inWorld)
{
  LightUniforms::Light source;
  source.Headlight = light.Headlight;
  for (int k = 0; k < 3; ++k)
  {
    source.Diffuse[k] = light.Diffuse[k] * lighting.Diffuse;
    source.Specular[k] = light.Specular[k] * lighting.Specular;
    source.Place[k] =
      light.Positional ? (light.Position[k] - world.Center[k]) / world.Unit : -light.Direction[k];
    source.Cone[k] = light.Direction[k];
  }
  if (!inWorld)
  {
    const Triple way = wayOf(light, world);
    std::copy(way.begin(), way.end(), source.Place.begin());
  }
  source.Place[3] = light.Positional ? 1 : 0;
  source.Cone[3] = light.ConeCosine;
  source.Attenuation = { { light.Attenuation[0], light.Attenuation[1] * world.Unit,
    light.Attenuation[2] * world.Unit * world.Unit, light.Exponent } };
  return source;
}

std::array<double, 4> sourceOf(const LightSource& light, const WorldTransform& world)
{
  if (!light.Positional)
  {
    const Triple way = wayOf(light, world);
    return { { way[0], way[1], way[2], 0 } };
  }
  Triple place{};
  for (int k = 0; k < 3; ++k)
  {
    place[k] = light.Position[k] - world.Center[k];
  }
  place = times(world.FromWorld, place);
  return { { place[0], place[1], place[2], 1 } };
}

// A smaller tolerance takes more samples of a ray than Mesa's llvmpipe has turns of loops for.
constexpr double LeastLightTolerance = 1.0 / 255.0;

// VTK's reach 0..1 maps to 0 to the whole diagonal, 2 radii, with higher resolution near 0.
double distanceOf(double reach) { return 2 * (1 - std::pow(1 - reach, 0.33)); }

} // namespace

bool LightUniforms::hasHeadlightShadows() const
{
  return std::any_of(this->Sources.begin(), this->Sources.end(),
    [](const Light& source) { return source.Headlight && source.ShadowStrength > 0; });
}

LightUniforms makeLightUniforms(const Lighting& lighting, const EffectOptions& options,
  vtkVolume* volume, const VolumeFrame& frame)
{
  LightUniforms lights;
  if (lighting.Lights.empty())
  {
    return lights;
  }
  const WorldTransform world = worldTransform(volume, frame);
  const bool local = std::any_of(lighting.Lights.begin(), lighting.Lights.end(),
    [](const LightSource& light) { return light.Positional; });
  lights.InWorld = local || !world.KeepsAngles;
  if (lights.InWorld)
  {
    lights.WorldMatrix = scaled(world.ToWorld, 1 / world.Unit);
    const Matrix normals = transposed(world.FromWorld);
    lights.NormalMatrix = scaled(normals, 1 / greatest(normals));
  }
  lights.LightsLeftOut = lighting.LeftOut;
  lights.TwoSided = lighting.TwoSided;
  lights.SpecularPower = lighting.SpecularPower;
  lights.ScatteringBlending = 0.5 * options.Scattering;
  lights.Ambient = { { lighting.Ambient, lighting.Ambient, lighting.Ambient } };
  const bool casts = options.Shadows != ShadowMethod::Off || options.Scattering > 0;
  for (const LightSource& light : lighting.Lights)
  {
    LightUniforms::Light source = lightSourceOf(light, lighting, world, lights.InWorld);
    for (int k = 0; k < 3; ++k)
    {
      lights.Ambient[k] += lighting.Ambient * light.Ambient[k];
    }
    if (casts && light.ShadowStrength > 0)
    {
      const bool hasChannel =
        lights.ShadowSources.size() < static_cast<std::size_t>(LightUniforms::MostShadowSources);
      if (source.Headlight)
      {
        source.ShadowStrength = light.ShadowStrength;
      }
      else if (hasChannel)
      {
        source.ShadowStrength = light.ShadowStrength;
        source.ShadowChannel = static_cast<int>(lights.ShadowSources.size());
        lights.ShadowSources.push_back(sourceOf(light, world));
      }
      else
      {
        ++lights.ShadowlessLights;
      }
    }
    lights.Sources.push_back(source);
  }
  lights.Reach = distanceOf(options.Reach);
  lights.Tolerance = std::max(options.Tolerance, LeastLightTolerance);
  lights.ThroughCuts = options.ThroughCuts;
  // A reach through the whole volume may not extend to surfaces outside.
  lights.OpaqueReach = options.Reach < 1 ? lights.Reach : std::numeric_limits<double>::infinity();
  if (options.Occlusion && lighting.Ambient > 0)
  {
    lights.OcclusionDirections = options.OcclusionDirections;
    lights.OcclusionRadius = 2 * options.OcclusionRadius;
  }
  return lights;
}

} // namespace tetmarch
