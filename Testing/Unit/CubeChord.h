// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The part of a ray in the unit cube, and which scalars it meets if the field is linear
 */
#ifndef tetmarch_testing_CubeChord_h
#define tetmarch_testing_CubeChord_h

#include "Fields.h"

#include <algorithm>
#include <array>

namespace tetmarch::testing
{
struct ScalarChord
{
  double Begin = 0; ///< depths
  double End = 0;
  double First = 0; ///< scalars there
  double Last = 0;
  double Optical = 0; ///< thickness: its length in scalar opacity unit distances

  double scalarAt(double depth) const
  {
    const double share = (depth - this->Begin) / (this->End - this->Begin);
    return this->First + (this->Last - this->First) * share;
  }
  /// Thickness of a unit of depth.
  double perDepth() const { return this->Optical / (this->End - this->Begin); }
};

/// The chord of the cube, whose half extent is that in the frame of the ray, enlarged by so much;
/// empty (End <= Begin) if the ray misses it.
template <typename Ray>
ScalarChord cubeChord(const std::array<double, 3>& halfExtent, const Ray& ray, const Field& field,
  double enlarged = 0.0)
{
  const std::array<double, 3> o{ { double(ray.origin.x), double(ray.origin.y),
    double(ray.origin.z) } };
  const std::array<double, 3> d{ { double(ray.direction.x), double(ray.direction.y),
    double(ray.direction.z) } };
  ScalarChord chord{ -1e3, 1e3, 0, 0, 0 };
  for (int k = 0; k < 3; ++k)
  {
    const double side = halfExtent[k] + enlarged;
    const double step = d[k] == 0 ? 1e-30 : d[k];
    const double a = (-side - o[k]) / step, b = (side - o[k]) / step;
    chord.Begin = std::max(chord.Begin, std::min(a, b));
    chord.End = std::min(chord.End, std::max(a, b));
  }
  const auto scalar = [&](double depth)
  {
    const auto at = [&](int k) { return 0.5 + (o[k] + depth * d[k]) * 0.5 / halfExtent[k]; };
    return field(at(0), at(1), at(2));
  };
  chord.First = scalar(chord.Begin);
  chord.Last = scalar(chord.End);
  return chord;
}
} // namespace tetmarch::testing

#endif
