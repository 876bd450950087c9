// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Light by brute force against closed forms: a cube of fog, a slab that shadows a slab.
#include "ClosedForms.h"
#include "Grids.h"
#include "LightTruth.h"
#include "SelfTestModels.h"

#include "vtkCellData.h"

#include <cmath>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

constexpr double Kappa = 3.0;

// The unit cube with that extinction everywhere, its colour (0.2, 0.4, 0.8).
OpticalModel fog()
{
  OpticalModel model = ramps({ 0.2, 0.4, 0.8 }, { 0.2, 0.4, 0.8 }, 1.0, 1.0);
  model.UnitDistance = 1.0 / Kappa;
  return model;
}

GroundTruthScene cubeOfFog() { return GroundTruthScene(jitteredLattice(3), fog()); }

TEST(LightTruth, TransmittanceInACubeOfFog)
{
  const GroundTruthScene cube = cubeOfFog();
  const LightTruth truth(cube);
  std::mt19937 generator(5);
  for (int i = 0; i < 200; ++i)
  {
    const Vec3 p = randomPoint(generator, 0.0, 1.0);
    const Vec3 d = randomDirection(generator);
    const double chord = boxChord(p, d, { 0, 0, 0 }, { 1, 1, 1 }, 0.0);
    EXPECT_NEAR(truth.transmittance(p, { d[0], d[1], d[2], 0 }), std::exp(-Kappa * chord), 1e-12);
    EXPECT_NEAR(truth.transmittance(p, { d[0], d[1], d[2], 0 }, 0.2),
      std::exp(-Kappa * std::min(chord, 0.2)), 1e-12);
    const Vec3 lamp = randomPoint(generator, 0.0, 1.0);
    const double far = std::hypot(lamp[0] - p[0], lamp[1] - p[1], lamp[2] - p[2]);
    EXPECT_NEAR(
      truth.transmittance(p, { lamp[0], lamp[1], lamp[2], 1 }), std::exp(-Kappa * far), 1e-12);
  }
}

TEST(LightTruth, AmbientLightInACubeOfFog)
{
  const GroundTruthScene cube = cubeOfFog();
  const LightTruth truth(cube);
  // Where nothing but fog is around, and on a face, where half of the directions are free.
  EXPECT_NEAR(truth.ambient({ 0.5, 0.5, 0.5 }, 0.3, 1), std::exp(-Kappa * 0.3), 1e-12);
  EXPECT_NEAR(truth.ambient({ 0.5, 0.5, 0.0 }, 0.3, 2), 0.5 + 0.5 * std::exp(-Kappa * 0.3), 1e-12);
  // At a depth h below a face: directions up leave the fog after h / z. By substitution.
  const double h = 0.1;
  double up = 0.0;
  const int steps = 200000;
  for (int i = 0; i < steps; ++i)
  {
    const double z = (i + 0.5) / steps;
    up += std::exp(-Kappa * std::min(0.3, h / z)) / steps;
  }
  EXPECT_NEAR(
    truth.ambient({ 0.5, 0.5, h }, 0.3, 12), 0.5 * up + 0.5 * std::exp(-Kappa * 0.3), 1e-5);
}

TEST(LightTruth, RaysInACubeOfFog)
{
  const GroundTruthScene cube = cubeOfFog();
  const LightTruth truth(cube);
  // Across the light, which comes against x: the transmittance is the same all along the ray.
  for (const double x : { 0.1, 0.5, 0.9 })
  {
    const auto across = truth.seen({ x, 0.45, -1 }, { 0, 0, 1 }, { 1, 0, 0, 0 });
    EXPECT_NEAR(across[1], 0.4 * std::exp(-Kappa * (1 - x)) * slabOpacity(Kappa, 1), 1e-6);
    EXPECT_NEAR(across[3], slabOpacity(Kappa, 1), 1e-12);
  }
  // With the light, it is lost on the way in and on the way out.
  const auto with = truth.seen({ -1, 0.4, 0.3 }, { 1, 0, 0 }, { -1, 0, 0, 0 });
  EXPECT_NEAR(with[2], 0.8 * 0.5 * slabOpacity(2 * Kappa, 1), 1e-6);
  // Towards the light, both ways together are through all of the fog.
  const auto against = truth.seen({ -1, 0.4, 0.3 }, { 1, 0, 0 }, { 1, 0, 0, 0 });
  EXPECT_NEAR(against[0], 0.2 * Kappa * std::exp(-Kappa), 1e-6);
  // A lamp on the ray, in the middle.
  const auto lamp = truth.seen({ -1, 0.4, 0.3 }, { 1, 0, 0 }, { 0.5, 0.4, 0.3, 1 });
  const double before = 0.5 * Kappa * std::exp(-0.5 * Kappa);
  const double behind = 0.5 * std::exp(-0.5 * Kappa) * slabOpacity(2 * Kappa, 0.5);
  EXPECT_NEAR(lamp[0], 0.2 * (before + behind), 1e-6);
}

// Above z = 1/2 the extinction is ten times that below: an edge in the light of a slanting sun.
TEST(LightTruth, ASlabShadowsASlab)
{
  const Grid grid = jitteredLattice(4, 0.0);
  vtkDataArray* c = grid->GetCellData()->GetScalars();
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    double bounds[6];
    grid->GetCellBounds(cell, bounds);
    c->SetComponent(cell, 0, bounds[4] >= 0.5 ? 1.0 : 0.0);
  }
  OpticalModel model = ramps({ 0.2, 0.4, 0.8 }, { 0.2, 0.4, 0.8 }, 0.1, 1.0);
  model.UnitDistance = 0.1;
  const GroundTruthScene slabs(grid, model, ScalarsOf::Cells);
  const LightTruth truth(slabs);
  for (const double z : { 0.05, 0.3, 0.45 })
  {
    const double light = std::exp(-10 * 0.5 - (0.5 - z));
    const auto below = truth.seen({ 0.3, -1, z }, { 0, 1, 0 }, { 0, 0, 1, 0 });
    EXPECT_NEAR(below[1], 0.4 * light * slabOpacity(1, 1), 1e-6);
  }
  // Light slants along x: near x = 1 it comes below the upper slab.
  const auto slanting = truth.seen({ -1, 0.4, 0.25 }, { 1, 0, 0 }, { 0.8, 0, 0.6, 0 }, 1e-9);
  double expected = 0.0;
  const int steps = 200000;
  for (int i = 0; i < steps; ++i)
  {
    const double x = (i + 0.5) / steps;
    const double out = (1 - x) / 0.8; // where the light enters by the side
    const double up = 0.25 / 0.6;     // where it has left the upper slab
    const double lower = std::min(out, up);
    const double upper = std::max(0.0, std::min(out, 0.75 / 0.6) - up);
    expected += std::exp(-x - lower - 10 * upper) / steps;
  }
  EXPECT_NEAR(slanting[2], 0.8 * expected, 1e-6);
}
} // namespace
