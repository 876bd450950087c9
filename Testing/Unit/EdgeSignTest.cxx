// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The predicate: exact signs, ties broken as one perturbation, 0 or 2 stabbed faces.
#include "Reference/PointKernel.h"
#include "Reference/PortablePointKernel.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>
#include <random>

namespace
{
using namespace tetmarch;

template <typename T>
int signOf(T x)
{
  return (x > T(0)) - (x < T(0));
}

// Coordinates as whole numbers, so that the products are exact in 128 bits.
using Wide = __int128;

template <typename Kernel, typename Real>
class Predicate
{
public:
  using Point = glsl::Vec2<Real>;

  bool left(const Point& p, unsigned i, const Point& q, unsigned j)
  {
    return this->March.turnsLeft(this->March.edgeCross(p, q), p, i, q, j);
  }

  // Sign and antisymmetry for two points with whole-number coordinates.
  ::testing::AssertionResult check(
    std::int64_t px, std::int64_t py, std::int64_t qx, std::int64_t qy, Real scale)
  {
    const Point p{ Real(px) * scale, Real(py) * scale };
    const Point q{ Real(qx) * scale, Real(qy) * scale };
    const Wide exact = Wide(px) * qy - Wide(qx) * py;
    const Real c = this->March.edgeCross(p, q);
    const Real back = this->March.edgeCross(q, p);
    if (signOf(c) != signOf(exact) || signOf(back) != -signOf(exact))
    {
      return ::testing::AssertionFailure() << px << ' ' << py << ' ' << qx << ' ' << qy << ": "
                                           << double(c) << ' ' << double(back);
    }
    if (this->left(p, 1, q, 2) == this->left(q, 2, p, 1) ||
        this->left(p, 2, q, 1) == this->left(q, 1, p, 2) ||
        (exact != 0 && this->left(p, 1, q, 2) != (exact > 0)))
    {
      return ::testing::AssertionFailure()
             << "not antisymmetric: " << px << ' ' << py << ' ' << qx << ' ' << qy;
    }
    return ::testing::AssertionSuccess();
  }

  // How many of the four faces of a projected tetrahedron the ray goes through.
  int stabbedFaces(const std::array<Point, 4>& p, const std::array<unsigned, 4>& id)
  {
    int stabbed = 0;
    for (int f = 0; f < 4; ++f)
    {
      const int a = (f + 1) % 4, b = (f + 2) % 4, c = (f + 3) % 4;
      const bool ab = this->left(p[a], id[a], p[b], id[b]);
      const bool bc = this->left(p[b], id[b], p[c], id[c]);
      const bool ca = this->left(p[c], id[c], p[a], id[a]);
      stabbed += ab == bc && bc == ca;
    }
    return stabbed;
  }

  Kernel March;
};

// Whole numbers of `bits` bits: any two; nearly collinear ones, a multiple and a little; equal
// ones.
template <typename Kernel, typename Real>
void expectExactSigns(int bits, Real scale, int pairs)
{
  Predicate<Kernel, Real> predicate;
  std::mt19937_64 random(3);
  const auto whole = [&](int width)
  {
    const auto magnitude = static_cast<std::int64_t>(random() >> (64 - width));
    return random() % 2 ? magnitude : -magnitude;
  };
  for (int i = 0; i < pairs; ++i)
  {
    const int width = 1 + static_cast<int>(random() % static_cast<unsigned>(bits - 1));
    const std::int64_t px = whole(width), py = whole(width);
    ASSERT_TRUE(predicate.check(px, py, whole(bits), whole(bits), scale));
    const std::int64_t factor = whole(bits - width);
    const std::int64_t dx = static_cast<std::int64_t>(random() % 3) - 1;
    const std::int64_t dy = static_cast<std::int64_t>(random() % 3) - 1;
    ASSERT_TRUE(predicate.check(px, py, px * factor + dx, py * factor + dy, scale));
    // The convergents of a slope: (a, b) and (c, d) with a d - b c = 1, as near as can be.
    std::int64_t a = 1, b = 0, c = 0, d = 1;
    while (std::max({ a, b, c, d }) < (std::int64_t(1) << (bits - 3)))
    {
      const std::int64_t quotient = 1 + static_cast<std::int64_t>(random() % 3);
      std::tie(a, c) = std::make_pair(a * quotient + c, a);
      std::tie(b, d) = std::make_pair(b * quotient + d, b);
    }
    ASSERT_TRUE(predicate.check(a, b, c, d, scale));
    ASSERT_TRUE(predicate.check(-a, b, c, -d, scale));
    ASSERT_TRUE(predicate.check(a, b, a, b, scale));
    ASSERT_TRUE(predicate.check(px, 0, 0, py, scale));
  }
}

TEST(EdgeSign, IsExactInFloat)
{
  // 6 million pairs; with any power of two in front that the flush to 0 leaves.
  expectExactSigns<PointKernel<float>, float>(24, 1.0f, 400000);
  expectExactSigns<PointKernel<float>, float>(24, std::ldexp(1.0f, -40), 300000);
  expectExactSigns<PointKernel<float>, float>(24, std::ldexp(1.0f, -7), 300000);
}

TEST(EdgeSign, IsExactInDouble)
{
  expectExactSigns<PointKernel<double>, double>(53, 1.0, 200000);
  expectExactSigns<PointKernel<double>, double>(53, std::ldexp(1.0, -52), 200000);
}

TEST(EdgeSign, IsExactInThePortableForm)
{
  // A bounding radius is 2^22; a vertex of a mesh that the ray meets is at most two away.
  expectExactSigns<PortablePointKernel<float>, float>(23, 1.0f, 400000);
  expectExactSigns<PortablePointKernel<float>, float>(24, 1.0f, 100000);
}

// Not only the sign: as a barycentric weight the value is good to some ulp, even of points nearly
// in line with the ray.
template <typename Kernel>
void expectValueWithin(double ulps, float scale)
{
  Kernel kernel;
  std::mt19937 random(5);
  const auto whole = [&]
  { return static_cast<float>(random() >> 8) * (random() % 2 ? 1.0f : -1.0f); };
  for (int i = 0; i < 1000000; ++i)
  {
    const glsl::Vec2<float> p{ whole() * scale, whole() * scale };
    glsl::Vec2<float> q{ whole() * scale, whole() * scale };
    if (i % 2)
    {
      q = { (std::floor(p.x / scale * 0.5f) + 1.0f) * scale,
        std::floor(p.y / scale * 0.5f) * scale };
    }
    const double exact = double(p.x) * double(q.y) - double(q.x) * double(p.y);
    const double error = std::abs(double(kernel.edgeCross(p, q)) - exact);
    // exact itself is rounded to double, which is 2^-29 of a float's ulp.
    ASSERT_LE(error, ulps * std::ldexp(std::abs(exact), -23) * (1.0 + 1e-6));
  }
}

// Jeannerod, Louvet and Muller 2013.
TEST(EdgeSign, ValueIsGoodToOneAndAHalfUlp)
{
  expectValueWithin<PointKernel<float>>(1.5, std::ldexp(1.0f, -24));
}

TEST(EdgeSign, ValueIsGoodToOneUlpInThePortableForm)
{
  expectValueWithin<PortablePointKernel<float>>(1.0, 1.0f);
}

// After the snap no term of the product leaves the range of normal numbers: flushing denormals, as
// GPUs may, changes nothing.
TEST(EdgeSign, NoDenormals)
{
  PointKernel<float> kernel;
  std::mt19937 random(6);
  const auto number = [&]
  {
    const float x = static_cast<float>(random() >> 8) + 1.0f;
    return std::ldexp(x, -24 - static_cast<int>(random() % 140)) * (random() % 2 ? 1.0f : -1.0f);
  };
  const auto isNormal = [](float x) { return x == 0.0f || std::isnormal(x); };
  for (int i = 0; i < 1000000; ++i)
  {
    const auto p = kernel.snapToPredicate({ number(), number() });
    const auto q = kernel.snapToPredicate({ number(), number() });
    const float w = q.x * p.y;
    ASSERT_TRUE(isNormal(p.x) && isNormal(q.y) && isNormal(w));
    ASSERT_TRUE(isNormal(std::fma(-q.x, p.y, w)) && isNormal(std::fma(p.x, q.y, -w)));
    ASSERT_TRUE(isNormal(kernel.edgeCross(p, q)));
  }
}

// All tetrahedra over 5 x 3 places and all orders of ids: 1.2 million with every kind of tie.
template <typename Kernel, typename Real>
void expectNoneOrTwoOfAll()
{
  Predicate<Kernel, Real> predicate;
  std::array<unsigned, 4> id;
  std::array<glsl::Vec2<Real>, 4> p;
  const auto place = [](int n) { return glsl::Vec2<Real>(Real(n % 5 - 2), Real(n / 5 % 3 - 1)); };
  for (int n = 0; n < 15 * 15 * 15 * 15; ++n)
  {
    p = { { place(n), place(n / 15), place(n / 225), place(n / 3375) } };
    std::iota(id.begin(), id.end(), 7u);
    do
    {
      const int stabbed = predicate.stabbedFaces(p, id);
      ASSERT_TRUE(stabbed == 0 || stabbed == 2) << stabbed << " of " << n;
    } while (std::next_permutation(id.begin(), id.end()));
  }
}

TEST(EdgeSign, NoneOrTwoStabbedFacesWithTies)
{
  expectNoneOrTwoOfAll<PointKernel<float>, float>();
  expectNoneOrTwoOfAll<PortablePointKernel<float>, float>();
}

template <typename Kernel, typename Real>
void expectNoneOrTwoOfRandom(int count)
{
  Predicate<Kernel, Real> predicate;
  std::mt19937 random(7);
  const std::array<unsigned, 4> id{ { 3, 9, 1, 4 } };
  int stabbedAtAll = 0;
  for (int i = 0; i < count; ++i)
  {
    std::array<glsl::Vec2<Real>, 4> p;
    // From tetrahedra about the ray down to slivers along a line through it.
    const int squash = static_cast<int>(random() % 24);
    for (auto& point : p)
    {
      const Real x = std::ldexp(Real(random() >> 8), -23) - Real(1);
      const Real y = std::ldexp(Real(random() >> 8), -23 - squash) - std::ldexp(Real(1), -squash);
      point = predicate.March.snapToPredicate({ x + y, i % 3 ? x - y : y });
    }
    const int stabbed = predicate.stabbedFaces(p, id);
    ASSERT_TRUE(stabbed == 0 || stabbed == 2);
    stabbedAtAll += stabbed / 2;
  }
  EXPECT_GT(stabbedAtAll, count / 20);
}

TEST(EdgeSign, NoneOrTwoStabbedFacesOfSlivers)
{
  expectNoneOrTwoOfRandom<PointKernel<float>, float>(1000000);
  expectNoneOrTwoOfRandom<PointKernel<double>, double>(300000);
  expectNoneOrTwoOfRandom<PortablePointKernel<float>, float>(1000000);
}
} // namespace
