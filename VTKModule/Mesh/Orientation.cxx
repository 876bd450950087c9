// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Orientation.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>

namespace tetmarch
{
namespace
{

// Six times the volume of a tetrahedron, its vertices taken by ascending id, and how far it may be
// off: by the rounding of the last sums, since differences and products of floats are exact in
// double, and by that of the positions before.
struct Volume
{
  double Value;
  double SumRounding;
  double PositionRounding;
};

Volume volumeOf(const TetMesh& mesh, Id tet)
{
  std::array<std::array<double, 3>, 3> e;
  const auto& ids = mesh.Tets[tet];
  const Vertex& o = mesh.Vertices[ids[0]];
  for (int i = 0; i < 3; ++i)
  {
    const Vertex& v = mesh.Vertices[ids[i + 1]];
    e[i] = { { double(v.X) - double(o.X), double(v.Y) - double(o.Y), double(v.Z) - double(o.Z) } };
  }
  double sum = 0;
  double size = 0;
  double longest = 0;
  for (int k = 0; k < 3; ++k)
  {
    const int l = (k + 1) % 3, m = (k + 2) % 3;
    const double left = e[0][l] * e[1][m];
    const double right = e[0][m] * e[1][l];
    sum += (left - right) * e[2][k];
    size += (std::abs(left) + std::abs(right)) * std::abs(e[2][k]);
    longest = std::max(longest, e[k][0] * e[k][0] + e[k][1] * e[k][1] + e[k][2] * e[k][2]);
  }
  return { sum, 1e-15 * size, std::ldexp(longest, -22) };
}

int signOf(double value, double rounding)
{
  return std::abs(value) <= rounding ? 0 : (value > 0 ? 1 : -1);
}

int orientation(const TetMesh& mesh, Id tet)
{
  const Volume volume = volumeOf(mesh, tet);
  return signOf(volume.Value, volume.SumRounding);
}

// Parity of moving vertex i behind the others, which keep their order.
int parity(Id i) { return i % 2 == 1 ? 1 : -1; }

// The orientation that a flat tetrahedron would have if it were blown up a little: neighbours see
// their common face from opposite sides.
int orientationByNeighbours(const TetMesh& mesh, Id start)
{
  std::map<Id, int> relative{ { start, 1 } };
  std::deque<Id> queue{ start };
  while (!queue.empty())
  {
    const Id tet = queue.front();
    queue.pop_front();
    const int sign = relative[tet];
    const int known = orientation(mesh, tet);
    if (known != 0)
    {
      return known * sign;
    }
    for (Id i = 0; i < 4; ++i)
    {
      const Link& link = mesh.Links[4 * std::size_t(tet) + i];
      if (link.Tet >= LinkOutside || relative.count(link.Tet))
      {
        continue;
      }
      Id j = 0;
      while (mesh.Tets[link.Tet][j] != link.Apex)
      {
        ++j;
      }
      relative[link.Tet] = -sign * parity(i) * parity(j);
      queue.push_back(link.Tet);
    }
  }
  return 1; // everything connected is flat: either side is as good
}

} // namespace

int inwardSide(const TetMesh& mesh, Id halfFace)
{
  const Volume volume = volumeOf(mesh, halfFace / 4);
  return signOf(volume.Value, volume.PositionRounding) * parity(halfFace % 4);
}

std::array<Id, 4> outwardFace(const TetMesh& mesh, Id halfFace)
{
  const Id tet = halfFace / 4;
  const Id opposite = halfFace % 4;
  int side = orientation(mesh, tet);
  if (side == 0)
  {
    side = orientationByNeighbours(mesh, tet);
  }
  std::array<Id, 4> face;
  int corner = 0;
  for (Id i = 0; i < 4; ++i)
  {
    if (i != opposite)
    {
      face[corner++] = mesh.Tets[tet][i];
    }
  }
  if (side * parity(opposite) > 0)
  {
    std::swap(face[1], face[2]);
  }
  face[3] = tet;
  return face;
}

} // namespace tetmarch
