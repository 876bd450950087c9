// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Variants/PredicateCases.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace tetmarch
{
namespace
{

using Points = std::array<std::int64_t, 4>; // p and q, whole numbers below 2^23

constexpr std::int64_t MostCoordinate = std::int64_t(1) << 23;

// A random integer below 2^bits in magnitude.
std::int64_t whole(std::mt19937& random, int bits)
{
  const auto magnitude = static_cast<std::int64_t>(random() >> (32 - bits));
  return random() % 2 ? magnitude : -magnitude;
}

// Convergents of a slope, whose cross product is 1 or -1: the minimum distance from a common line
// through 0.
Points convergents(std::mt19937& random)
{
  Points points{ { 1, 0, 0, 1 } };
  while (std::max(points[0], points[1]) < MostCoordinate / 4)
  {
    const auto quotient = static_cast<std::int64_t>(1 + random() % 3);
    points = { { points[0] * quotient + points[2], points[1] * quotient + points[3], points[0],
      points[1] } };
  }
  return points;
}

Points anyPoints(std::mt19937& random)
{
  return { { whole(random, 23), whole(random, 23), whole(random, 23), whole(random, 23) } };
}

// A point and its multiple, which is a tie, or a neighbour of the multiple.
Points multiples(std::mt19937& random)
{
  const std::int64_t x = whole(random, 12), y = whole(random, 12), factor = whole(random, 10);
  const auto beside = [&] { return static_cast<std::int64_t>(random() % 3) - 1; };
  const std::int64_t dx = beside(), dy = beside();
  return { { x, y, x * factor + dx, y * factor + dy } };
}

// A point and one next to the midpoint between it and the ray.
Points halves(std::mt19937& random)
{
  const std::int64_t x = whole(random, 23), y = whole(random, 23);
  return { { x, y, x / 2 + 1, y / 2 } };
}

Points pointsOf(int i, std::mt19937& random)
{
  switch (i / 2 % 4)
  {
    case 0:
      return convergents(random);
    case 1:
      return multiples(random);
    case 2:
      return halves(random);
    default:
      return anyPoints(random);
  }
}

std::int64_t crossOf(const Points& p) { return p[0] * p[3] - p[2] * p[1]; }

// Whether p, as vertex 1, then q, as vertex 2, turn left: the rule of Shaders/tet/edge_sign.glsl.
bool turnsLeft(const Points& p)
{
  const std::int64_t cross = crossOf(p), dx = p[2] - p[0], dy = p[3] - p[1];
  const std::int64_t turn = cross != 0 ? cross : (dx != 0 ? -dx : dy);
  return turn >= 0;
}

} // namespace

PredicateCases::PredicateCases()
{
  std::mt19937 random(17);
  for (int i = 0; i < Count; ++i)
  {
    Case made;
    made.Points = pointsOf(i, random);
    made.Exact = i % 2 == 0;
    // With few bits, products and sums of a ray's vectors are exact.
    const int bits = made.Exact ? 6 : 23;
    const auto number = [&](double greatest)
    { return std::ldexp(greatest * static_cast<double>(whole(random, bits)), -bits); };
    using Vector = std::array<double, 3>;
    Vector vertex{}, origin{};
    std::array<Vector, 3> axes{};
    for (int k = 0; k < 3; ++k)
    {
      vertex[k] = number(0.5);
      origin[k] = number(0.25);
      for (Vector& axis : axes)
      {
        axis[k] = number(1);
      }
    }
    for (int a = 0; a < 3; ++a)
    {
      for (int k = 0; k < 3; ++k)
      {
        made.Projected[a] += (vertex[k] - origin[k]) * axes[a][k];
      }
    }
    this->Cases.push_back(made);
    for (const std::int64_t coordinate : made.Points)
    {
      this->Texels.push_back(static_cast<float>(coordinate));
    }
    for (const Vector& v : { vertex, origin, axes[0], axes[1], axes[2] })
    {
      for (const double x : v)
      {
        this->Texels.push_back(static_cast<float>(x));
      }
      this->Texels.push_back(0);
    }
  }
}

// Comparisons with NaN are false.
bool PredicateCases::isRight(const Case& known, const float* edge)
{
  const auto exact = static_cast<double>(crossOf(known.Points));
  const auto isValue = [exact](double found)
  {
    const bool sameSign = exact > 0 ? found > 0 : (exact < 0 ? found < 0 : found == 0);
    return sameSign && std::abs(found - exact) <= std::ldexp(std::abs(exact), -22);
  };
  const float left = turnsLeft(known.Points) ? 1.0f : 0.0f;
  return isValue(double(edge[0])) && isValue(double(edge[1])) && edge[2] == left &&
         edge[3] == 1 - left;
}

bool PredicateCases::isRight(const Case& known, const float* projection, double scale)
{
  const double most = known.Exact ? 0 : std::ldexp(1.0, -20);
  const double found[3] = { double(projection[0]) / scale, double(projection[1]) / scale,
    double(projection[2]) };
  bool right = projection[3] == 1;
  for (int k = 0; k < 3; ++k)
  {
    right = right && std::abs(found[k] - known.Projected[k]) <= most;
  }
  return right;
}

int PredicateCases::countWrong(
  const std::vector<float>& edges, const std::vector<float>& projections, bool fused) const
{
  const double scale = fused ? 65536.0 : 4194304.0; // Shaders/tet/edge_sign.glsl
  int wrong = 0;
  for (std::size_t i = 0; i < this->Cases.size(); ++i)
  {
    const Case& known = this->Cases[i];
    const bool right = isRight(known, &edges[4 * i]) && isRight(known, &projections[4 * i], scale);
    wrong += right ? 0 : 1;
  }
  return wrong;
}

} // namespace tetmarch
