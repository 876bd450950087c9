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
  LitComponentRays(const Grid& grid, int components, bool independent = false, bool cells = false)
    : ComponentRays(grid, components, independent, cells)
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

  /// Returns what is wrong.
  std::string use(const AccuracyLevel& level)
  {
    const std::string error = this->ComponentRays::use(level);
    if (this->Effects.Gradients.empty())
    {
      // Constant in cells, the scalars say nothing of the gradient.
      const Vec3 g = this->gradient();
      const std::array<float, 3> gradient{ { float(g[0]), float(g[1]), float(g[2]) } };
      this->Effects.Gradients =
        this->OfCells ? decltype(this->Effects.Gradients)(this->Rays.Mesh.Vertices.size(), gradient)
                      : vertexGradients(this->Rays.Mesh);
    }
    return error;
  }

  template <typename Kernel>
  Kernel kernel() const
  {
    Kernel made = this->ComponentRays::kernel<Kernel>();
    made.useEffects(this->Effects);
    return made;
  }

  template <typename Ray>
  Rgba truth(const Ray& ray, ScalarChord chord) const
  {
    chord.Optical *= this->Density;
    return this->inLight(ray, this->ComponentRays::truth(ray, chord));
  }

  /// What the light makes of a premultiplied colour on a ray.
  template <typename Ray>
  Rgba inLight(const Ray& ray, const Rgba& color) const
  {
    return this->lightOn(ray).of(color);
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

  /// Makes opacity grow with the gradient.
  void addGradientOpacity()
  {
    const Vec3 g = this->gradient();
    this->Effects.GradientOpacity.Values = { 0.0f, 1.0f };
    this->Density = 0.4;
    this->Effects.GradientOpacityScale = this->Density / std::sqrt(dot(g, g));
  }

  /// By gradients of cells; after use().
  void useCellGradients() { this->Effects.Gradients = cellGradients(this->Rays.Mesh); }

  EffectData Effects;
  double Density = 1.0; ///< the share of the extinction that is left
};
} // namespace tetmarch::testing

#endif
