// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Light/LightUniforms.h"

#include "Mesh/TetMesh.h"

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

// From the normalised frame of the mesh to the world, both with the mesh's centre as origin.
struct Frame
{
  Matrix ToWorld{};
  Matrix FromWorld{};
  Triple Center{};         // in the world
  double Unit = 1;         // of the world's coordinates in the shader
  bool KeepsAngles = true; // turned, mirrored, scaled alike along all axes
};

// Whether columns are orthogonal and of one length, as far as float could tell.
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

Frame frameOf(vtkVolume* volume, const TetMesh& mesh)
{
  Frame frame;
  vtkMatrix4x4* matrix = volume->GetMatrix();
  double rows[3][3];
  double inverse[3][3];
  for (int r = 0; r < 3; ++r)
  {
    frame.Center[r] = matrix->GetElement(r, 3);
    for (int c = 0; c < 3; ++c)
    {
      rows[r][c] = matrix->GetElement(r, c) * mesh.Radius;
      frame.ToWorld[3 * r + c] = rows[r][c];
      frame.Center[r] += matrix->GetElement(r, c) * mesh.Center[c];
    }
  }
  vtkMath::Invert3x3(rows, inverse);
  for (int i = 0; i < 9; ++i)
  {
    frame.FromWorld[i] = inverse[i / 3][i % 3];
  }
  const double most = greatest(frame.ToWorld);
  frame.Unit = most > 0 ? most : 1;
  frame.KeepsAngles = keepsAngles(frame.ToWorld);
  return frame;
}

Matrix transposed(const Matrix& m)
{
  return { { m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8] } };
}

// The unit vector to a light that is far away, in the frame of the mesh.
Triple wayOf(const LightSource& light, const Frame& frame)
{
  return unit(
    times(frame.FromWorld, { { -light.Direction[0], -light.Direction[1], -light.Direction[2] } }));
}

LightUniforms::Light lightSourceOf(
  const LightSource& light, const Lighting& lighting, const Frame& frame, bool inWorld)
{
  LightUniforms::Light source;
  source.Headlight = light.Headlight;
  for (int k = 0; k < 3; ++k)
  {
    source.Diffuse[k] = light.Diffuse[k] * lighting.Diffuse;
    source.Specular[k] = light.Specular[k] * lighting.Specular;
    source.Place[k] =
      light.Positional ? (light.Position[k] - frame.Center[k]) / frame.Unit : -light.Direction[k];
    source.Cone[k] = light.Direction[k];
  }
  if (!inWorld)
  {
    const Triple way = wayOf(light, frame);
    std::copy(way.begin(), way.end(), source.Place.begin());
  }
  source.Place[3] = light.Positional ? 1 : 0;
  source.Cone[3] = light.ConeCosine;
  source.Attenuation = { { light.Attenuation[0], light.Attenuation[1] * frame.Unit,
    light.Attenuation[2] * frame.Unit * frame.Unit, light.Exponent } };
  return source;
}

std::array<double, 4> sourceOf(const LightSource& light, const Frame& frame)
{
  if (!light.Positional)
  {
    const Triple way = wayOf(light, frame);
    return { { way[0], way[1], way[2], 0 } };
  }
  Triple place{};
  for (int k = 0; k < 3; ++k)
  {
    place[k] = light.Position[k] - frame.Center[k];
  }
  place = times(frame.FromWorld, place);
  return { { place[0], place[1], place[2], 1 } };
}

// VTK's reach runs from nothing to the diagonal, and most of it is near; the diagonal is 2 radii.
double distanceOf(double reach) { return 2 * (1 - std::pow(1 - reach, 0.33)); }

} // namespace

bool LightUniforms::hasHeadlightShadows() const
{
  return std::any_of(this->Sources.begin(), this->Sources.end(),
    [](const Light& source) { return source.Headlight && source.ShadowStrength > 0; });
}

LightUniforms makeLightUniforms(
  const Lighting& lighting, const EffectOptions& options, vtkVolume* volume, const TetMesh& mesh)
{
  LightUniforms lights;
  if (lighting.Lights.empty())
  {
    return lights;
  }
  const Frame frame = frameOf(volume, mesh);
  const bool local = std::any_of(lighting.Lights.begin(), lighting.Lights.end(),
    [](const LightSource& light) { return light.Positional; });
  lights.InWorld = local || !frame.KeepsAngles;
  if (lights.InWorld)
  {
    lights.WorldMatrix = scaled(frame.ToWorld, 1 / frame.Unit);
    const Matrix normals = transposed(frame.FromWorld);
    lights.NormalMatrix = scaled(normals, 1 / greatest(normals));
  }
  lights.TwoSided = lighting.TwoSided;
  lights.SpecularPower = lighting.SpecularPower;
  lights.ScatteringBlending = 0.5 * options.Scattering;
  lights.Ambient = { { lighting.Ambient, lighting.Ambient, lighting.Ambient } };
  const bool casts = options.Shadows != ShadowMethod::Off || options.Scattering > 0;
  for (const LightSource& light : lighting.Lights)
  {
    LightUniforms::Light source = lightSourceOf(light, lighting, frame, lights.InWorld);
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
        lights.ShadowSources.push_back(sourceOf(light, frame));
      }
      else
      {
        ++lights.ShadowlessLights;
      }
    }
    lights.Sources.push_back(source);
  }
  lights.Reach = distanceOf(options.Reach);
  // Through all of the volume is not yet all the way to what stands outside.
  lights.OpaqueReach = options.Reach < 1 ? lights.Reach : std::numeric_limits<double>::infinity();
  if (options.Occlusion && lighting.Ambient > 0)
  {
    lights.OcclusionDirections = options.OcclusionDirections;
    lights.OcclusionRadius = 2 * options.OcclusionRadius;
  }
  return lights;
}

} // namespace tetmarch
