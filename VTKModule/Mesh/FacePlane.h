// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The plane of a boundary face, its unit normal outwards, in double precision.
#ifndef TetMarchMeshFacePlane_h
#define TetMarchMeshFacePlane_h

#include "Mesh/TetMesh.h"

#include <cmath>

namespace tetmarch
{

struct FacePlane
{
  std::array<double, 3> Normal{ { 0, 0, 0 } }; // 0 for a face without area
  double Offset = 0;

  FacePlane(const TetMesh& mesh, Id face)
  {
    const auto& f = mesh.BoundaryFaces[face];
    const auto a = position(mesh.Vertices[f[0]]);
    const auto b = position(mesh.Vertices[f[1]]);
    const auto c = position(mesh.Vertices[f[2]]);
    double square = 0;
    for (int k = 0; k < 3; ++k)
    {
      const int l = (k + 1) % 3, m = (k + 2) % 3;
      this->Normal[k] = (b[l] - a[l]) * (c[m] - a[m]) - (b[m] - a[m]) * (c[l] - a[l]);
      square += this->Normal[k] * this->Normal[k];
    }
    const double scale = square > 0 ? 1 / std::sqrt(square) : 0;
    for (int k = 0; k < 3; ++k)
    {
      this->Normal[k] *= scale;
      this->Offset += this->Normal[k] * a[k];
    }
  }

  bool hasArea() const
  {
    return this->Normal[0] != 0 || this->Normal[1] != 0 || this->Normal[2] != 0;
  }

  FacePlane reversed() const
  {
    FacePlane other = *this;
    for (double& component : other.Normal)
    {
      component = -component;
    }
    other.Offset = -this->Offset;
    return other;
  }

  /** The height of a vertex above the plane, in mesh radii. */
  double heightOf(const Vertex& v) const
  {
    const auto p = position(v);
    return this->Normal[0] * p[0] + this->Normal[1] * p[1] + this->Normal[2] * p[2] - this->Offset;
  }

private:
  static std::array<double, 3> position(const Vertex& v)
  {
    return { { double(v.X), double(v.Y), double(v.Z) } };
  }
};

} // namespace tetmarch

#endif
