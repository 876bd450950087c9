// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Rays through dependent components in light, which is known in closed form
 *
 * The components are linear in space: the gradient of that which the opacity comes from is the same
 * everywhere, and so is the light of a sun along a ray.
 */
#ifndef tetmarch_testing_LitComponentRays_h
#define tetmarch_testing_LitComponentRays_h

#include "Mesh/Gradients.h"

#include "ComponentRays.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tetmarch::testing
{
inline double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

inline Vec3 normalized(const Vec3& v)
{
  const double length = std::sqrt(dot(v, v));
  return { { v[0] / length, v[1] / length, v[2] / length } };
}

/// Light at a point: what it makes of a premultiplied colour.
struct LocalLight
{
  Vec3 Diffuse;
  Vec3 Specular;

  Rgba of(const Rgba& seen) const
  {
    Rgba lit = seen;
    for (int k = 0; k < 3; ++k)
    {
      lit[k] = seen[k] * this->Diffuse[k] + this->Specular[k] * seen[3];
    }
    return lit;
  }
};

/// Dependent components in the light of a sun.
class LitComponentRays : public ComponentRays
{
public:
  LitComponentRays(const Grid& grid, int components, bool cells = false)
    : ComponentRays(grid, components, false, cells)
  {
    LightUniforms::Light sun;
    sun.Diffuse = { { 0.8, 0.6, 0.4 } };
    sun.Specular = { { 0.4, 0.2, 0.3 } };
    const Vec3 toSun = normalized({ { 0.3, 0.5, -0.7 } });
    sun.Place = { { toSun[0], toSun[1], toSun[2], 0.0 } };
    this->Effects.Lights.Sources = { sun };
    this->Effects.Lights.TwoSided = true;
    this->Effects.Lights.Ambient = { { 0.1, 0.2, 0.3 } };
    this->Effects.Lights.SpecularPower = 8.0;
  }

  template <typename Kernel, typename Real>
  Kernel litKernel(bool ofCells = false)
  {
    if (this->Effects.Gradients.empty())
    {
      const TetMesh& mesh = this->Rays.Mesh;
      this->Effects.Gradients = ofCells         ? cellGradients(mesh)
                                : this->OfCells ? vertexGradients(mesh, this->Rays.Scalars)
                                                : vertexGradients(mesh);
    }
    Kernel made = this->kernel<Kernel, Real>();
    made.useEffects(this->Effects);
    return made;
  }

  /// The gradient of the stored scalar, in the normalised frame.
  Vec3 gradient() const
  {
    const Field& field = this->Fields.back();
    const double width = this->Rays.Range.width();
    Vec3 g{};
    for (int k = 0; k < 3; ++k)
    {
      const double rise = field(k == 0, k == 1, k == 2) - field(0.0, 0.0, 0.0);
      g[k] = rise * 0.5 / this->Rays.Mesh.Frame.HalfExtent[k] / width;
    }
    return g;
  }

  template <typename Ray>
  LocalLight lightOn(const Ray& ray) const
  {
    const LightUniforms::Light& sun = this->Effects.Lights.Sources[0];
    const Vec3 normal = normalized(this->gradient());
    const Vec3 toSun{ { sun.Place[0], sun.Place[1], sun.Place[2] } };
    const Vec3 eye{ { -double(ray.direction.x), -double(ray.direction.y),
      -double(ray.direction.z) } };
    const double cosine = dot(normal, toSun);
    Vec3 mirrored{};
    for (int k = 0; k < 3; ++k)
    {
      mirrored[k] = 2.0 * cosine * normal[k] - toSun[k];
    }
    const double highlight =
      std::pow(std::max(dot(mirrored, eye), 0.0), this->Effects.Lights.SpecularPower);
    LocalLight light{ this->Effects.Lights.Ambient, sun.Specular };
    for (int k = 0; k < 3; ++k)
    {
      light.Diffuse[k] += sun.Diffuse[k] * std::abs(cosine);
      light.Specular[k] *= highlight;
    }
    return light;
  }

  /// Makes the sun so much brighter that a bound which forgets the light is too small.
  void blaze()
  {
    for (double& channel : this->Effects.Lights.Sources[0].Diffuse)
    {
      channel *= 15.0;
    }
  }

  /// Makes opacity grow with the gradient; returns the share of the extinction that is left.
  double addGradientOpacity()
  {
    const Vec3 g = this->gradient();
    this->Effects.GradientOpacity.Values = { 0.0f, 1.0f };
    this->Effects.GradientOpacityScale = 0.4 / std::sqrt(dot(g, g));
    return 0.4;
  }

  EffectData Effects;
};
} // namespace tetmarch::testing

#endif
