// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Rays of every kind that gives a traversal trouble
 */
#ifndef tetmarch_testing_RandomRays_h
#define tetmarch_testing_RandomRays_h

#include "Mesh/TetMesh.h"

#include "LatticeGrids.h"

#include <array>
#include <cmath>
#include <random>

namespace tetmarch::testing
{
/// Every other ray is generic; the rest go through vertices, along edges, in planes of faces, and
/// along or diagonal to the axes, where projections tie exactly.
class RandomRays
{
public:
  explicit RandomRays(unsigned seed)
    : Generator(seed)
  {
  }

  enum class Kind
  {
    Generic,
    ThroughVertex,
    AlongEdge,
    InFace,
    AxisThroughVertex,
    AxisInPlane,
    DiagonalThroughVertex
  };
  Kind LastKind = Kind::Generic;

  template <typename Kernel, typename Real>
  typename Kernel::Ray next(Kernel& kernel, const TetMesh& mesh)
  {
    static constexpr Kind Degenerate[6] = { Kind::ThroughVertex, Kind::AlongEdge, Kind::InFace,
      Kind::AxisThroughVertex, Kind::AxisInPlane, Kind::DiagonalThroughVertex };
    ++this->Count;
    this->LastKind = this->Count % 2 ? Kind::Generic : Degenerate[this->Count / 2 % 6];
    Vec3 point = this->pointInBox(mesh);
    Vec3 direction = this->direction();
    const auto& tet = mesh.Tets[this->Generator() % mesh.Tets.size()];
    const unsigned corner = this->Generator() % 4;
    const Vec3 a = position(mesh, tet[corner]);
    const Vec3 b = position(mesh, tet[(corner + 1) % 4]);
    const Vec3 c = position(mesh, tet[(corner + 2) % 4]);
    switch (this->LastKind)
    {
      case Kind::Generic:
        break;
      case Kind::ThroughVertex:
        point = a;
        break;
      case Kind::AlongEdge:
        point = a;
        direction = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
        break;
      case Kind::InFace:
        point = a;
        for (int k = 0; k < 3; ++k)
        {
          direction[k] = 0.5 * (b[k] + c[k]) - a[k];
        }
        break;
      case Kind::AxisThroughVertex:
        point = a;
        direction = this->axis();
        break;
      case Kind::AxisInPlane:
        point[this->Generator() % 3] = a[0];
        direction = this->axis();
        break;
      case Kind::DiagonalThroughVertex:
        point = a;
        for (double& x : direction)
        {
          x = static_cast<double>(this->Generator() % 3) - 1.0;
        }
        break;
    }
    const double length = std::hypot(direction[0], direction[1], direction[2]);
    if (length == 0.0)
    {
      direction = { 0.0, 0.0, 1.0 };
    }
    const double scale = length == 0.0 ? 1.0 : 1.0 / length;
    return kernel.rayThrough({ Real(point[0]), Real(point[1]), Real(point[2]) },
      { Real(direction[0] * scale), Real(direction[1] * scale), Real(direction[2] * scale) });
  }

  double uniformBetween(double low, double high)
  {
    return low + (high - low) * uniform(this->Generator);
  }

private:
  static Vec3 position(const TetMesh& mesh, Id vertex)
  {
    const Vertex& v = mesh.Vertices[vertex];
    return { double(v.X), double(v.Y), double(v.Z) };
  }

  Vec3 pointInBox(const TetMesh& mesh)
  {
    Vec3 p;
    for (int k = 0; k < 3; ++k)
    {
      p[k] = this->uniformBetween(-mesh.Frame.HalfExtent[k], mesh.Frame.HalfExtent[k]);
    }
    return p;
  }

  Vec3 direction()
  {
    Vec3 d;
    double length;
    do
    {
      for (double& x : d)
      {
        x = this->uniformBetween(-1.0, 1.0);
      }
      length = std::hypot(d[0], d[1], d[2]);
    } while (length > 1.0 || length < 0.1);
    return d;
  }

  Vec3 axis()
  {
    Vec3 d{ 0.0, 0.0, 0.0 };
    d[this->Generator() % 3] = this->Generator() % 2 ? 1.0 : -1.0;
    return d;
  }

  std::mt19937 Generator;
  unsigned Count = 0;
};
} // namespace tetmarch::testing

#endif
