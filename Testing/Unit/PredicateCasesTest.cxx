// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The cases by which a GL is checked: the CPU's arithmetic answers all of them right, and each way
// in which a GL may round makes some of the answers wrong.
#include "Variants/PredicateCases.h"
#include "Reference/PointKernel.h"
#include "Reference/PortablePointKernel.h"

#include <cmath>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;

struct Answers
{
  std::vector<float> Edges;
  std::vector<float> Projections;
};

// The answers of a kernel, with other arithmetic in its place where that is given.
template <typename Kernel>
Answers answersOf(const PredicateCases& cases,
  float (*cross)(const glsl::Vec2<float>&, const glsl::Vec2<float>&) = nullptr,
  float (*dot)(const glsl::Vec3<float>&, const glsl::Vec3<float>&) = nullptr)
{
  Kernel kernel;
  Answers answers;
  const std::vector<float>& texels = cases.texels();
  const auto vector = [&](std::size_t texel)
  { return glsl::Vec3<float>(texels[4 * texel], texels[4 * texel + 1], texels[4 * texel + 2]); };
  for (std::size_t i = 0; i < PredicateCases::Count; ++i)
  {
    const std::size_t first = i * PredicateCases::TexelsPerCase;
    const float* points = &texels[4 * first];
    const glsl::Vec2<float> p(points[0], points[1]), q(points[2], points[3]);
    const float alone = kernel.edgeCross(p, q);
    const float among = cross ? cross(p, q) : alone;
    const float back = cross ? cross(q, p) : kernel.edgeCross(q, p);
    for (const float number : { alone, among, kernel.turnsLeft(among, p, 1, q, 2) ? 1.0f : 0.0f,
           kernel.turnsLeft(back, q, 2, p, 1) ? 1.0f : 0.0f })
    {
      answers.Edges.push_back(number);
    }
    typename Kernel::Ray ray{};
    ray.origin = vector(first + 2);
    ray.right = vector(first + 3);
    ray.up = vector(first + 4);
    ray.direction = vector(first + 5);
    const glsl::Vec3<float> vertex = vector(first + 1);
    const glsl::Vec3<float> point = kernel.project(ray, vertex);
    const float depth = dot ? dot(vertex - ray.origin, ray.direction) : point.z;
    for (const float number : { point.x, point.y, depth, depth == point.z ? 1.0f : 0.0f })
    {
      answers.Projections.push_back(number);
    }
  }
  return answers;
}

int countWrong(const PredicateCases& cases, const Answers& answers, bool fused)
{
  return cases.countWrong(answers.Edges, answers.Projections, fused);
}

TEST(PredicateCases, AreAnsweredRightByBothForms)
{
  const PredicateCases cases;
  ASSERT_EQ(cases.texels().size(), std::size_t(4) * PredicateCases::Width * PredicateCases::Side);
  const Answers fused = answersOf<PointKernel<float>>(cases);
  const Answers whole = answersOf<PortablePointKernel<float>>(cases);
  EXPECT_EQ(countWrong(cases, fused, true), 0);
  EXPECT_EQ(countWrong(cases, whole, false), 0);
  EXPECT_GT(countWrong(cases, fused, false), PredicateCases::Count * 9 / 10);
}

// What the multiply-add of a GL may be: the product is rounded before the sum.
float roundedTwice(const glsl::Vec2<float>& p, const glsl::Vec2<float>& q)
{
  const float w = q.x * p.y;
  const float left = q.x * p.y, right = p.x * q.y;
  return (w - left) + (right - w);
}

// What a compiler may make of the projection in one place, but not in another.
float contracted(const glsl::Vec3<float>& a, const glsl::Vec3<float>& b)
{
  return std::fma(a.z, b.z, std::fma(a.y, b.y, a.x * b.x));
}

TEST(PredicateCases, FindArithmeticThatLosesRays)
{
  const PredicateCases cases;
  const int some = PredicateCases::Count / 8;
  EXPECT_GT(countWrong(cases, answersOf<PointKernel<float>>(cases, roundedTwice), true), 2 * some);
  // Of the half of the rays whose vectors have all bits.
  EXPECT_GT(
    countWrong(cases, answersOf<PointKernel<float>>(cases, nullptr, contracted), true), some);
  EXPECT_GT(
    countWrong(cases, answersOf<PortablePointKernel<float>>(cases, nullptr, contracted), false),
    some);
}

TEST(PredicateCases, FindAnswersThatAreNone)
{
  const PredicateCases cases;
  for (const float number : { 0.0f, 1.0f, std::nanf(""), INFINITY })
  {
    const std::vector<float> same(std::size_t(4) * PredicateCases::Count, number);
    EXPECT_EQ(cases.countWrong(same, same, true), PredicateCases::Count) << number;
    EXPECT_EQ(cases.countWrong(same, same, false), PredicateCases::Count) << number;
  }
}

// Each of the eight numbers counts: one that is off makes one case wrong.
TEST(PredicateCases, FindOneWrongNumber)
{
  const PredicateCases cases;
  const Answers right = answersOf<PointKernel<float>>(cases);
  const std::size_t at = 4 * 1000; // exact projection, any points
  for (std::size_t k = 0; k < 4; ++k)
  {
    Answers edge = right;
    edge.Edges[at + k] = k < 2 ? -edge.Edges[at + k] : 1 - edge.Edges[at + k];
    EXPECT_EQ(countWrong(cases, edge, true), 1) << k;
    Answers projection = right;
    float& number = projection.Projections[at + k];
    number = k < 3 ? std::nextafter(number, 2 * number) : 0;
    EXPECT_EQ(countWrong(cases, projection, true), 1) << k;
  }
}
} // namespace
