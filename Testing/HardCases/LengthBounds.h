// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Rays beside a ray, and what lengths may be
 */
#ifndef tetmarch_testing_LengthBounds_h
#define tetmarch_testing_LengthBounds_h

#include "Mesh/TetMesh.h"
#include "Reference/GlslLanguage.h"

#include "ClosedForms.h"
#include "HardCase.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetmarch::testing
{
namespace lengths
{
constexpr double Eps = 5.9604644775390625e-08; // 2^-24
// How far double may be from brute force: a boundary that is met at an angle of 1e-8 magnifies the
// rounding of 1e-16 to that.
constexpr double DoubleSlack = 1e-8;

// Every so many rays are compared with brute force, which costs as much as all the others.
inline int bruteForceStride(const TetMesh& mesh)
{
  return std::clamp(static_cast<int>(mesh.Tets.size() / 64), 8, 4096);
}

// The chord of a box made greater on all sides, or smaller, so that nothing may be left of it.
inline double chordOfGrown(const Box& box, double by, const Vec3& origin, const Vec3& direction)
{
  Box grown = box;
  for (int k = 0; k < 3; ++k)
  {
    grown.Low[k] -= by;
    grown.High[k] += by;
    if (grown.Low[k] > grown.High[k])
    {
      return 0.0;
    }
  }
  return boxChord(origin, direction, grown.Low, grown.High);
}

// The least and the greatest of some lengths.
struct Span
{
  double Least = std::numeric_limits<double>::infinity();
  double Most = -std::numeric_limits<double>::infinity();

  void include(double length)
  {
    this->Least = std::min(this->Least, length);
    this->Most = std::max(this->Most, length);
  }
  bool holds(double length, double slack) const
  {
    return length >= this->Least - slack && length <= this->Most + slack;
  }
};

template <typename To, typename From>
typename To::Ray converted(const From& ray)
{
  const auto vec = [](const auto& v) {
    return glsl::Vec3<double>{ double(v.x), double(v.y), double(v.z) };
  };
  typename To::Ray result;
  result.origin = vec(ray.origin);
  result.right = vec(ray.right);
  result.up = vec(ray.up);
  result.direction = vec(ray.direction);
  return result;
}

// The march takes the points that lie neither to the right nor up of the ray, and how far they are
// along its direction. Each of the three is a vector of floats, which are as orthonormal as floats
// are.
struct Line
{
  Vec3 Direction; // of unit length
  double DepthPerLength;
};
template <typename Ray>
Line lineOf(const Ray& ray)
{
  const auto across = glsl::cross(ray.right, ray.up);
  const double along = glsl::dot(across, ray.direction);
  const double length = std::copysign(std::sqrt(glsl::dot(across, across)), along);
  return { { across.x / length, across.y / length, across.z / length }, along / length };
}

template <typename Ray>
Ray movedAside(Ray ray, double right, double up)
{
  ray.origin = ray.origin + ray.right * right + ray.up * up;
  return ray;
}
} // namespace lengths
} // namespace tetmarch::testing

#endif
