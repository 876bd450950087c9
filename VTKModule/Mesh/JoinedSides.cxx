// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/JoinedSides.h"

#include <cmath>

namespace tetmarch
{
namespace
{

class SideFinder
{
public:
  explicit SideFinder(const TetMesh& mesh)
    : Vertices(mesh.Vertices)
    , Count(mesh.Curvilinear->cells())
    , Strides(mesh.Curvilinear->pointStrides())
  {
  }

  // Whether the last points along an axis are the first ones.
  bool closes(int axis) const
  {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const Id across = this->Strides[axis] * this->Count[axis];
    for (Id i = 0; i <= this->Count[u]; ++i)
    {
      for (Id j = 0; j <= this->Count[v]; ++j)
      {
        const Id first = this->Strides[u] * i + this->Strides[v] * j;
        if (!this->meet(first, first + across))
        {
          return false;
        }
      }
    }
    return true;
  }

  // Whether the points of a side are one along another axis.
  bool shrinks(int side, int along) const
  {
    const int axis = side / 2, other = 3 - axis - along;
    const Id begin = side % 2 == 0 ? 0 : this->Strides[axis] * this->Count[axis];
    for (Id i = 0; i <= this->Count[other]; ++i)
    {
      const Id first = begin + this->Strides[other] * i;
      for (Id j = 1; j <= this->Count[along]; ++j)
      {
        if (!this->meet(first, first + this->Strides[along] * j))
        {
          return false;
        }
      }
    }
    return true;
  }

private:
  bool meet(Id a, Id b) const
  {
    const float rounding = std::ldexp(1.0f, -24);
    const Vertex& p = this->Vertices[a];
    const Vertex& q = this->Vertices[b];
    return std::abs(p.X - q.X) <= rounding && std::abs(p.Y - q.Y) <= rounding &&
           std::abs(p.Z - q.Z) <= rounding;
  }

  const std::vector<Vertex>& Vertices;
  std::array<Id, 3> Count;
  std::array<Id, 3> Strides;
};

} // namespace

JoinedSides joinedSides(const TetMesh& mesh)
{
  const SideFinder finder(mesh);
  JoinedSides joins;
  for (int axis = 0; axis < 3; ++axis)
  {
    joins.Rings[axis] = finder.closes(axis);
    for (int side = 2 * axis; side < 2 * axis + 2; ++side)
    {
      for (int along = 0; along < 3; ++along)
      {
        joins.Poles[side] |= along != axis && finder.shrinks(side, along) ? 1u << along : 0u;
      }
    }
  }
  return joins;
}

} // namespace tetmarch
