// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What rays see in the other blend modes than composite, in closed form
 */
#ifndef tetmarch_testing_BlendedColors_h
#define tetmarch_testing_BlendedColors_h

#include "BlendedRays.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <type_traits>
#include <vector>

namespace tetmarch::testing
{
inline const Field AlongX = [](double x, double, double) { return x; };
/// Tolerances of colours. Stored positions, scalars and tables are floats also for kernels in
/// double; short chords magnify their rounding.
constexpr double ByDouble = 4e-6;
constexpr double ByFloat = 1e-4;

inline Rgba gray(double value) { return { { value, value, value, 1 } }; }

/// All rays have the colours that `expected` says. It returns false of a ray that it doesn't
/// know for sure.
template <typename Kernel, typename Expected>
void expectRaysBy(const BlendedRays& rays, const Field& field, const Expected& expected)
{
  const double bound = std::is_same_v<RealOf<Kernel>, double> ? ByDouble : ByFloat;
  auto kernel = rays.kernel<Kernel>();
  int count = 0;
  rays.forEachRay(kernel, field,
    [&](const typename Kernel::Ray& ray, const ScalarChord& chord)
    {
      Rgba known{};
      if (!expected(chord, known))
      {
        return;
      }
      ++count;
      const Rgba found = pixelOf(kernel, marchOf(kernel, ray, chord), chord);
      for (int k = 0; k < 4; ++k)
      {
        ASSERT_NEAR(found[k], known[k], bound) << "channel " << k << " of ray " << count;
      }
    });
  EXPECT_GT(count, 150);
}

template <template <typename> class Kernel, typename Expected>
void expectRays(const BlendedRays& rays, const Field& field, const Expected& expected)
{
  expectRaysBy<Kernel<double>>(rays, field, expected);
  expectRaysBy<Kernel<float>>(rays, field, expected);
}

inline bool knowNothing(const ScalarChord&, Rgba& known)
{
  known = {};
  return true;
}

/// The values that lie between two scalars, in the order in which they are met.
inline std::vector<double> crossed(std::vector<double> values, const ScalarChord& c)
{
  std::sort(values.begin(), values.end());
  if (c.Last < c.First)
  {
    std::reverse(values.begin(), values.end());
  }
  std::vector<double> met;
  for (double v : values)
  {
    if ((v > c.First) != (v > c.Last) && (met.empty() || met.back() != v))
    {
      met.push_back(v);
    }
  }
  return met;
}

/// Surfaces of these scalars, one behind the other.
inline Rgba composited(const std::vector<double>& values)
{
  Rgba color{};
  for (double v : values)
  {
    const Rgba next = BlendedRays::premultiplied(v);
    const double seen = 1 - color[3];
    for (int k = 0; k < 4; ++k)
    {
      color[k] += seen * next[k];
    }
  }
  return color;
}
} // namespace tetmarch::testing

#endif
