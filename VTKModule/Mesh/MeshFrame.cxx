// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/MeshFrame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetmarch
{
namespace
{

// The volume of a tetrahedron of such edges is a normal number.
constexpr double LeastRadius = 1e-100;

} // namespace

std::string findFrame(const std::vector<Position>& positions, TetMesh& mesh)
{
  if (positions.empty())
  {
    return {};
  }
  Position low, high;
  low.fill(std::numeric_limits<double>::max());
  high.fill(std::numeric_limits<double>::lowest());
  for (const Position& position : positions)
  {
    for (int k = 0; k < 3; ++k)
    {
      low[k] = std::min(low[k], position[k]);
      high[k] = std::max(high[k], position[k]);
    }
  }
  Position half;
  for (int k = 0; k < 3; ++k)
  {
    mesh.Center[k] = 0.5 * low[k] + 0.5 * high[k];
    // From the centre as it is rounded: in a mesh a few roundings wide that is not the middle.
    half[k] = std::max(high[k] - mesh.Center[k], mesh.Center[k] - low[k]);
  }
  const double radius = std::hypot(half[0], half[1], half[2]);
  if (radius > 0 && radius < LeastRadius)
  {
    return "The points of the grid lie within less than 1e-100 of each other, which is too little "
           "for volumes in double precision. Scale them.";
  }
  mesh.Radius = radius > 0 ? radius : 1;
  for (int k = 0; k < 3; ++k)
  {
    mesh.HalfExtent[k] = half[k] / mesh.Radius;
  }
  return {};
}

Vertex vertexAt(const Position& position, const TetMesh& mesh)
{
  std::array<float, 3> p;
  for (int k = 0; k < 3; ++k)
  {
    p[k] = static_cast<float>((position[k] - mesh.Center[k]) / mesh.Radius);
  }
  return { p[0], p[1], p[2], 0.0f };
}

} // namespace tetmarch
