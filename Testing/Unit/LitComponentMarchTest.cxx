// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What rays see of dependent components in light, against a quadrature and the light in closed
// form; and that they keep the tolerance, by a bound that holds.
//
// The components are linear in space: the gradient of that which the opacity comes from is the same
// everywhere, and so is the light of a sun along a ray.
#include "Mesh/Gradients.h"
#include "Reference/LitComponentKernel.h"

#include "ErrorTally.h"

#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

using Triple = std::array<double, 3>;

double dot(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Triple normalized(const Triple& v)
{
  const double length = std::sqrt(dot(v, v));
  return { { v[0] / length, v[1] / length, v[2] / length } };
}

// What light makes of colours of a volume of some opacity.
struct LightThere
{
  Triple Diffuse;
  Triple Specular;

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

class LitComponentRays : public ComponentRays
{
public:
  LitComponentRays(const Grid& grid, int components, bool cells = false)
    : ComponentRays(grid, components, false, cells)
  {
    LightUniforms::Light sun;
    sun.Diffuse = { { 0.8, 0.6, 0.4 } };
    sun.Specular = { { 0.4, 0.2, 0.3 } };
    const Triple way = normalized({ { 0.3, 0.5, -0.7 } });
    sun.Place = { { way[0], way[1], way[2], 0.0 } };
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

  // Of the stored scalar, in the normalised frame.
  Triple gradient() const
  {
    const Field& field = this->Fields.back();
    const double width = this->Rays.Range.width();
    Triple g{};
    for (int k = 0; k < 3; ++k)
    {
      const double rise = field(k == 0, k == 1, k == 2) - field(0.0, 0.0, 0.0);
      g[k] = rise * 0.5 / this->Rays.Mesh.Frame.HalfExtent[k] / width;
    }
    return g;
  }

  template <typename Ray>
  LightThere lightOn(const Ray& ray) const
  {
    const LightUniforms::Light& sun = this->Effects.Lights.Sources[0];
    const Triple normal = normalized(this->gradient());
    const Triple way{ { sun.Place[0], sun.Place[1], sun.Place[2] } };
    const Triple eye{ { -double(ray.direction.x), -double(ray.direction.y),
      -double(ray.direction.z) } };
    const double turned = dot(normal, way);
    Triple mirrored{};
    for (int k = 0; k < 3; ++k)
    {
      mirrored[k] = 2.0 * turned * normal[k] - way[k];
    }
    const double highlight =
      std::pow(std::max(dot(mirrored, eye), 0.0), this->Effects.Lights.SpecularPower);
    LightThere light{ this->Effects.Lights.Ambient, sun.Specular };
    for (int k = 0; k < 3; ++k)
    {
      light.Diffuse[k] += sun.Diffuse[k] * std::abs(turned);
      light.Specular[k] *= highlight;
    }
    return light;
  }

  // So much brighter that a bound which forgets the light is too small.
  void blaze()
  {
    for (double& channel : this->Effects.Lights.Sources[0].Diffuse)
    {
      channel *= 15.0;
    }
  }

  // Opacity grows with the gradient; what that leaves of the extinction.
  double addGradientOpacity()
  {
    const Triple g = this->gradient();
    this->Effects.GradientOpacity.Values = { 0.0f, 1.0f };
    this->Effects.GradientOpacityScale = 0.4 / std::sqrt(dot(g, g));
    return 0.4;
  }

  EffectData Effects;
};

// Of all rays against the quadrature. density: what is left of the extinction.
template <typename Kernel, typename Real>
ErrorTally tallyOf(LitComponentRays& rays, double density = 1.0, bool cellGradients = false)
{
  ErrorTally tally;
  Kernel kernel = rays.litKernel<Kernel, Real>(cellGradients);
  rays.Rays.forEachRay<Kernel, Real>(
    kernel, rays.Fields[0],
    [&](const typename Kernel::Ray& ray, const Chord& chord)
    {
      Chord thinned = chord;
      thinned.Optical *= density;
      double bound = 0;
      const Rgba seen = pixelOf(kernel, ray, chord, bound);
      tally.add(seen, rays.lightOn(ray).of(rays.byQuadrature(ray, thinned)), bound);
    },
    400);
  return tally;
}

template <template <typename> class Kernel>
void expectTolerance(int components)
{
  for (const int cubes : { 1, 5 })
  {
    LitComponentRays rays(jitteredLattice(cubes, 0.15), components);
    for (const double tolerance : { 1.0 / 32.0, 1.0 / 255.0, 1.0 / 1024.0 })
    {
      AccuracyLevel level = levelOf(Accuracy::Default, tolerance);
      level.LeastTableEntries = 16384; // what is between entries is no part of the bound
      ASSERT_EQ(rays.use(level), "");
      const ErrorTally tally = tallyOf<Kernel<float>, float>(rays);
      std::cout << "[ MEASURED ] " << components << " components, " << cubes << "^3 cubes, 1/"
                << 1.0 / tolerance << ": " << tally << '\n';
      EXPECT_GT(tally.Rays, 150);
      EXPECT_LE(tally.Worst, tolerance);
      EXPECT_LE(tally.BeyondBound, Rounding);
    }
    ASSERT_EQ(rays.use(GroundTruthAccuracy), "");
    const ErrorTally exact = tallyOf<Kernel<double>, double>(rays);
    std::cout << "[ MEASURED ] in double: " << exact << '\n';
    EXPECT_LE(exact.Worst, 1e-5);
  }
}

TEST(LitComponentMarch, ColorAndOpacityKeepTheTolerance)
{
  expectTolerance<LitColorAndOpacityPointKernel>(2);
}
TEST(LitComponentMarch, DirectColorKeepsTheTolerance)
{
  expectTolerance<LitDirectColorPointKernel>(4);
}

// Pieces that are taken as they are promise nothing, but say by how much they may be off.
template <template <typename> class Kernel>
void expectBoundOfWholePieces(int components)
{
  AccuracyLevel fast = levelOf(Accuracy::Fast, 1);
  fast.LeastTableEntries = fast.MostTableEntries = 16384;
  fast.MostTrials = 0;
  LitComponentRays rays(jitteredLattice(2, 0.15), components);
  rays.blaze();
  ASSERT_EQ(rays.use(fast), "");
  const ErrorTally tally = tallyOf<Kernel<double>, double>(rays);
  std::cout << "[ MEASURED ] " << tally << '\n';
  EXPECT_LE(tally.BeyondBound, Rounding);
  EXPECT_GT(tally.Worst, 1e-2);
  EXPECT_LE(tally.Bound, 40 * tally.Error);
}

TEST(LitComponentMarch, BoundsOfWhatIsTakenAsItIs)
{
  expectBoundOfWholePieces<LitColorAndOpacityPointKernel>(2);
  expectBoundOfWholePieces<LitDirectColorPointKernel>(4);
}

// By the gradient of the component that the opacity comes from, at vertices or of cells.
template <template <typename> class Kernel>
void expectGradientOpacity(int components, bool cellGradients)
{
  LitComponentRays rays(jitteredLattice(3, 0.15), components);
  ASSERT_EQ(rays.use(GroundTruthAccuracy), "");
  const double density = rays.addGradientOpacity();
  const ErrorTally tally = tallyOf<Kernel<double>, double>(rays, density, cellGradients);
  std::cout << "[ MEASURED ] " << tally << '\n';
  EXPECT_GT(tally.Rays, 150);
  EXPECT_LE(tally.Worst, 1e-5);
}

TEST(LitComponentMarch, GradientOpacityIsByTheComponentOfTheOpacity)
{
  expectGradientOpacity<LitColorAndOpacityPointKernel>(2, false);
  expectGradientOpacity<LitDirectColorPointKernel>(4, false);
  expectGradientOpacity<LitColorAndOpacityCellGradientKernel>(2, true);
  expectGradientOpacity<LitDirectColorCellGradientKernel>(4, true);
}

// Where each vertex has a gradient of its own, light changes along a piece: the bound of that is
// kept, too, against pieces as short as it takes.
template <template <typename> class Kernel>
void expectBoundOfChangingLight(int components)
{
  LitComponentRays rays(jitteredLattice(3, 0.15), components);
  std::mt19937 random(9);
  std::normal_distribution<float> normal;
  for (std::size_t i = 0; i < rays.Rays.Mesh.Vertices.size(); ++i)
  {
    rays.Effects.Gradients.push_back({ { normal(random), normal(random), normal(random) } });
  }
  rays.Effects.Lights.SpecularPower = 3.0;
  rays.blaze();
  std::vector<Rgba> exact;
  const auto forEach = [&](const AccuracyLevel& level, const auto& call)
  {
    ASSERT_EQ(rays.use(level), "");
    auto kernel = rays.litKernel<Kernel<double>, double>();
    rays.Rays.forEachRay<Kernel<double>, double>(
      kernel, rays.Fields[0],
      [&](const auto& ray, const Chord& chord)
      {
        double bound = 0;
        const Rgba seen = pixelOf(kernel, ray, chord, bound);
        call(seen, bound);
      },
      400);
  };
  forEach(GroundTruthAccuracy, [&](const Rgba& seen, double) { exact.push_back(seen); });
  AccuracyLevel level = levelOf(Accuracy::Default, 1.0 / 32.0);
  level.LeastTableEntries = 16384;
  ErrorTally tally;
  forEach(
    level, [&](const Rgba& seen, double bound) { tally.add(seen, exact[tally.Rays], bound); });
  std::cout << "[ MEASURED ] " << tally << '\n';
  EXPECT_GT(tally.Rays, 150);
  EXPECT_GT(tally.Worst, 1.0 / 32.0);
  EXPECT_LE(tally.BeyondBound, Rounding);
}

TEST(LitComponentMarch, BoundsOfChangingLight)
{
  expectBoundOfChangingLight<LitColorAndOpacityPointKernel>(2);
  expectBoundOfChangingLight<LitDirectColorPointKernel>(4);
}

// Cells of constant scalars are exact: where a ray meets one alone, it has the colour of that in
// the light on it.
template <template <typename> class Kernel>
void expectCells(int components)
{
  LitComponentRays rays(twoTetsSharingFace(), components, true);
  ASSERT_EQ(rays.use(GroundTruthAccuracy), "");
  const Triple g = rays.gradient();
  rays.Effects.Gradients.assign(rays.Rays.Mesh.Vertices.size(),
    { { static_cast<float>(g[0]), static_cast<float>(g[1]), static_cast<float>(g[2]) } });
  auto kernel = rays.litKernel<Kernel<double>, double>();
  RandomRays random(3);
  int checked = 0;
  for (int i = 0; i < 200; ++i)
  {
    const auto ray = random.next<Kernel<double>, double>(kernel, rays.Rays.Mesh);
    const auto march = kernel.castPlainRay(ray, -1, 3.0, -3.0, 3.0);
    const auto color = kernel.pixelOf(march.radiance, 3.0);
    const LightThere light = rays.lightOn(ray);
    const auto isMedium = [&](int cell)
    {
      std::vector<double> tuple(components);
      rays.Data->GetCellData()->GetScalars()->GetTuple(cell, tuple.data());
      const Rgba medium = mediumAt(rays.Property, tuple);
      const double share = color.w / medium[3];
      const Rgba lit =
        light.of({ { medium[0] * share, medium[1] * share, medium[2] * share, color.w } });
      return std::abs(color.x - lit[0]) < 1e-4 && std::abs(color.y - lit[1]) < 1e-4 &&
             std::abs(color.z - lit[2]) < 1e-4;
    };
    if (march.cells == 1 && color.w > 1e-2)
    {
      EXPECT_TRUE(isMedium(0) || isMedium(1));
      ++checked;
    }
  }
  EXPECT_GT(checked, 20);
}

TEST(LitComponentMarch, CellsHaveTheirColorInTheLight)
{
  expectCells<LitColorAndOpacityCellKernel>(2);
  expectCells<LitDirectColorCellKernel>(4);
}
} // namespace
