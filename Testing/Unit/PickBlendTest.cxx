// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Where rays are picked in the blend modes that show scalars or surfaces, in closed form: a linear
// field in the unit cube.
#include "Reference/PickExtremeKernel.h"
#include "Reference/PickIsosurfacesKernel.h"
#include "Reference/PickSumKernel.h"

#include "BlendedRays.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

// Of opacity(s) s from 0 to s.
double gatheredTo(double s) { return 0.1 * s * s + 0.2 * s * s * s; }

struct Expected
{
  bool Sure = true; // else rounding decides
  bool Hit = true;
  double Share = 0; // of the chord
};

using Rule = std::function<Expected(const ScalarChord& chord, double threshold)>;

// The depth follows from the scalar, which may hardly change along the chord: then it is uncertain.
template <typename Kernel>
void expectPicks(const BlendedRays& rays, const Rule& rule, double tolerance, const char* what)
{
  using Real = RealOf<Kernel>;
  auto kernel = rays.kernel<Kernel>();
  int hits = 0, misses = 0, count = 0;
  double worst = 0.0;
  rays.forEachRay(kernel, linearField(),
    [&](const typename Kernel::Ray& ray, const ScalarChord& chord)
    {
      const double threshold = std::array<double, 5>{ { 0.0, 0.3, 0.5, 0.8, 1.0 } }[count++ % 5];
      const Expected expected = rule(chord, threshold);
      const double slope = std::abs(chord.Last - chord.First) / (chord.End - chord.Begin);
      if (!expected.Sure || slope < 0.01)
      {
        return;
      }
      const Real length = Real(chord.perDepth());
      const double left = std::max(1.0 - threshold, 1.0 / (1 << 24));
      const auto pick = kernel.pickOn(ray, length, Real(chord.Begin), Real(chord.End), Real(left));
      ASSERT_EQ(pick.hit, expected.Hit) << "ray " << count << ", threshold " << threshold;
      hits += pick.hit ? 1 : 0;
      misses += pick.hit ? 0 : 1;
      if (pick.hit)
      {
        const double scalar = chord.First + (chord.Last - chord.First) * expected.Share;
        worst = std::max(worst, std::abs(double(pick.scalar) - scalar));
        ASSERT_NEAR(double(pick.depth), chord.Begin + (chord.End - chord.Begin) * expected.Share,
          tolerance / slope)
          << "ray " << count << ", threshold " << threshold;
      }
    });
  EXPECT_GT(hits, 100);
  EXPECT_LE(worst, tolerance);
  std::cout << "[ MEASURED ] " << what << ": " << hits << " hits, " << misses
            << " misses, scalars within " << worst << '\n';
}

// Tolerances in double and in float. Extremes are found within 1e-6, and so are fractions of a sum;
// near the end of a ray that may be ten times as much of the scalar.
template <template <typename> class Kernel>
void expectBoth(const BlendedRays& rays, const Rule& rule, const char* what)
{
  expectPicks<Kernel<double>>(rays, rule, 2e-5, what);
  expectPicks<Kernel<float>>(rays, rule, 1e-4, what);
}

class PickBlend : public ::testing::Test
{
protected:
  BlendedRays Rays{ jitteredLattice(5, 0.15, 1, linearField()) };
};

// Where the greatest or least scalar is, if it is opaque enough.
TEST_F(PickBlend, Extremes)
{
  for (const bool greatest : { true, false })
  {
    this->Rays.use(greatest ? BlendMode::Maximum : BlendMode::Minimum);
    expectBoth<PickExtremeKernel>(
      this->Rays,
      [greatest](const ScalarChord& c, double threshold)
      {
        const bool atEnd = (c.Last > c.First) == greatest;
        const double opacity = BlendedRays::opacity(atEnd ? c.Last : c.First);
        return Expected{ std::abs(opacity - threshold) > 1e-3, opacity > threshold,
          atEnd ? 1.0 : 0.0 };
      },
      greatest ? "maximum" : "minimum");
  }
}

// Up to the point the sum is the threshold times the whole sum.
TEST_F(PickBlend, Sums)
{
  for (const std::array<double, 2>& range :
    { std::array<double, 2>{ { -1e38, 1e38 } }, std::array<double, 2>{ { 0.45, 0.6 } } })
  {
    for (const BlendMode mode : { BlendMode::Average, BlendMode::Additive })
    {
      this->Rays.use(mode, range);
      const std::array<double, 2> counts =
        mode == BlendMode::Average ? range : std::array<double, 2>{ { -1e38, 1e38 } };
      expectBoth<PickSumKernel>(
        this->Rays,
        [counts](const ScalarChord& c, double threshold)
        {
          const auto counted = [&](double s) { return std::clamp(s, counts[0], counts[1]); };
          const double from = gatheredTo(counted(c.First)), to = gatheredTo(counted(c.Last));
          // By halving: the sum up to a point grows along the chord.
          double low = 0.0, high = 1.0;
          for (int i = 0; i < 60; ++i)
          {
            const double middle = 0.5 * (low + high);
            const double sum = gatheredTo(counted(c.First + (c.Last - c.First) * middle)) - from;
            const bool reached = std::abs(sum) >= threshold * std::abs(to - from) && sum != 0.0;
            (reached ? high : low) = middle;
          }
          const bool something = std::abs(to - from) > 1e-3;
          return Expected{ something || to == from, something, high };
        },
        mode == BlendMode::Average ? "average" : "additive");
    }
  }
}

// The surface that makes it opaque enough, with opacities of 0.2 + 0.6 s.
TEST_F(PickBlend, Surfaces)
{
  const std::vector<double> values{ 0.2, 0.35, 0.5, 0.55, 0.7 };
  this->Rays.useSurfaces(values);
  expectBoth<PickIsosurfacesKernel>(
    this->Rays,
    [&](const ScalarChord& c, double threshold)
    {
      std::vector<double> ordered = values;
      if (c.Last < c.First)
      {
        std::reverse(ordered.begin(), ordered.end());
      }
      Expected expected{ true, false, 0.0 };
      double left = 1.0;
      for (const double value : ordered)
      {
        const double share = (value - c.First) / (c.Last - c.First);
        expected.Sure = expected.Sure && std::abs(share) > 1e-3 && std::abs(share - 1.0) > 1e-3;
        if (share > 0.0 && share < 1.0 && !expected.Hit)
        {
          left *= 1.0 - BlendedRays::opacity(value);
          expected.Hit = 1.0 - left >= threshold - 1e-12;
          expected.Share = share;
        }
      }
      return expected;
    },
    "surfaces");
}
} // namespace
