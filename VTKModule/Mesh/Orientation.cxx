// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Orientation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tetmarch
{
namespace
{

// Six times the volume of a tetrahedron, its vertices taken by ascending id, and its rounding.
struct Volume
{
  double Value;
  double Rounding;
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
  double longest = 0;
  for (int k = 0; k < 3; ++k)
  {
    const int l = (k + 1) % 3, m = (k + 2) % 3;
    const double left = e[0][l] * e[1][m];
    const double right = e[0][m] * e[1][l];
    sum += (left - right) * e[2][k];
    longest = std::max(longest, e[k][0] * e[k][0] + e[k][1] * e[k][1] + e[k][2] * e[k][2]);
  }
  return { sum, volumeRounding(longest) };
}

} // namespace

double signedVolume(const TetMesh& mesh, Id tet) { return volumeOf(mesh, tet).Value; }

int volumeSign(const TetMesh& mesh, Id tet)
{
  const Volume volume = volumeOf(mesh, tet);
  return std::abs(volume.Value) <= volume.Rounding ? 0 : (volume.Value > 0 ? 1 : -1);
}

std::array<Id, 4> outwardFace(const TetMesh& mesh, Id halfFace, int sign)
{
  const Id tet = halfFace / 4;
  const Id opposite = halfFace % 4;
  std::array<Id, 4> face;
  int corner = 0;
  for (Id i = 0; i < 4; ++i)
  {
    if (i != opposite)
    {
      face[corner++] = mesh.Tets[tet][i];
    }
  }
  if (sign * parity(opposite) > 0)
  {
    std::swap(face[1], face[2]);
  }
  face[3] = halfFace;
  return face;
}

} // namespace tetmarch
