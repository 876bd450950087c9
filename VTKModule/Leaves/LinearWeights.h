// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The value of a fitted linear function as a weighted sum of the values that it fits.
#ifndef TetMarchLeavesLinearWeights_h
#define TetMarchLeavesLinearWeights_h

#include "Mesh/LinearFit.h"

#include <algorithm>
#include <vector>

namespace tetmarch
{

/** Weights of values at these points (at least one) for the value at the origin of the linear
 * function that fits them by least squares; constant in directions in which the points don't
 * differ. Weights below 0 become 0, so that the value lies between the least and the greatest; then
 * all are scaled so that their sum is 1. */
inline std::vector<double> linearWeights(const std::vector<Vector3>& points)
{
  Vector3 mean{};
  for (const Vector3& point : points)
  {
    add(1.0 / static_cast<double>(points.size()), point, mean);
  }
  System3 system;
  system.Right = scaled(-1, mean);
  for (const Vector3& point : points)
  {
    const Vector3 step = point - mean;
    for (int i = 0; i < 3; ++i)
    {
      add(step[i], step, system.Rows[i]);
    }
  }
  // Keeps the system regular where the points lie in a plane or on a line.
  const double spread = system.Rows[0][0] + system.Rows[1][1] + system.Rows[2][2];
  for (int i = 0; i < 3; ++i)
  {
    system.Rows[i][i] += spread > 0 ? 1e-10 * spread : 1;
  }
  const Vector3 slope = system.solution(system.determinant());
  std::vector<double> weights;
  double sum = 0;
  for (const Vector3& point : points)
  {
    weights.push_back(
      std::max(0.0, 1.0 / static_cast<double>(points.size()) + dot(slope, point - mean)));
    sum += weights.back();
  }
  for (double& weight : weights)
  {
    weight /= sum;
  }
  return weights;
}

} // namespace tetmarch

#endif
