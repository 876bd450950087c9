// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Test cases of the predicate for a GL, with exact results.
#ifndef TetMarchVariantsPredicateCases_h
#define TetMarchVariantsPredicateCases_h

#include <array>
#include <cstdint>
#include <vector>

namespace tetmarch
{

/**
 * Each case has two points for a cross product (Shaders/tet/edge_sign.glsl), mostly so near to a
 * line through the ray that rounding twice gives the wrong sign, and a vertex to be projected along
 * a ray (Shaders/tet/projection.glsl): in every other case the results of the projection are exact,
 * in the others rounded, but to the same bits at each place of the shader.
 */
class PredicateCases
{
public:
  static constexpr int Side = 64; // of a square of cases
  static constexpr int Count = Side * Side;
  static constexpr int TexelsPerCase = 6;
  static constexpr int Width = Side * TexelsPerCase;

  /** The cases are deterministic. */
  PredicateCases();

  /** An image of Width times Side texels of four numbers. Those of a case: both points; the vertex;
   * origin, right, up, direction of the ray. */
  const std::vector<float>& texels() const { return this->Texels; }

  /**
   * The number of wrong results, in the form with fused multiply-add or in the other one. Four
   * numbers each. Of an edge: the cross product outside and inside of a loop, and 1 or 0 for a left
   * turn of the points 1, then 2, and 2, then 1. Of a projection: right, up, depth, and whether
   * they are the same outside and inside of a loop.
   */
  int countWrong(
    const std::vector<float>& edges, const std::vector<float>& projections, bool fused) const;

private:
  struct Case
  {
    std::array<std::int64_t, 4> Points{};
    bool Exact = false;
    std::array<double, 3> Projected{};
  };

  static bool isRight(const Case& known, const float* edge);
  static bool isRight(const Case& known, const float* projection, double scale);

  std::vector<Case> Cases;
  std::vector<float> Texels;
};

} // namespace tetmarch

#endif
