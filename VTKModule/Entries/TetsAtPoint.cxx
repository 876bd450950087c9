// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Entries/TetsAtPoint.h"

#include "Entries/SeenTets.h"
#include "Parallel/ParallelFor.h"

#include <cmath>

namespace tetmarch
{
namespace
{

// Whether the point is not beyond the plane of any face. A flat tetrahedron has no inside: the
// point must be near all of its planes.
bool isWithinFaces(const std::array<Vector3, 4>& corners, const Vector3& point, double margin)
{
  for (std::size_t i = 0; i < 4; ++i)
  {
    const Vector3& a = corners[(i + 1) % 4];
    const Vector3 normal = cross(corners[(i + 2) % 4] - a, corners[(i + 3) % 4] - a);
    const double rounding = margin * std::sqrt(dot(normal, normal));
    const double height = dot(normal, corners[i] - a);
    const double at = dot(normal, point - a);
    const bool isFlat = std::abs(height) <= rounding;
    if (isFlat ? std::abs(at) > 2 * rounding : (height > 0 ? at : -at) < -rounding)
    {
      return false;
    }
  }
  return true;
}

} // namespace

void TetsAtPoint::Box::add(const Vertex& v)
{
  const std::array<float, 3> at{ { v.X, v.Y, v.Z } };
  for (std::size_t k = 0; k < 3; ++k)
  {
    this->Low[k] = std::min(this->Low[k], at[k]);
    this->High[k] = std::max(this->High[k], at[k]);
  }
}

bool TetsAtPoint::Box::contains(const Vector3& point, double margin) const
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (point[k] < double(this->Low[k]) - margin || point[k] > double(this->High[k]) + margin)
    {
      return false;
    }
  }
  return true;
}

TetsAtPoint::TetsAtPoint(const TetMesh& mesh)
  : Boxes(clustersOf(mesh))
{
  parallelFor(0, static_cast<vtkIdType>(this->Boxes.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto cluster = static_cast<std::size_t>(begin); cluster < static_cast<std::size_t>(end);
           ++cluster)
      {
        for (std::size_t tet = cluster * TetsOfCluster; tet < endOfCluster(mesh, cluster); ++tet)
        {
          for (const Id id : mesh.Tets[tet])
          {
            this->Boxes[cluster].add(mesh.Vertices[id]);
          }
        }
      }
    });
}

std::vector<Id> TetsAtPoint::find(const TetMesh& mesh, const Vector3& point, double margin) const
{
  const auto isAt = [&](std::size_t tet)
  {
    Box box;
    std::array<Vector3, 4> corners;
    for (std::size_t i = 0; i < 4; ++i)
    {
      const Vertex& v = mesh.Vertices[mesh.Tets[tet][i]];
      box.add(v);
      corners[i] = position(v);
    }
    return box.contains(point, margin) && isWithinFaces(corners, point, margin);
  };
  std::vector<Id> found;
  for (std::size_t cluster = 0; cluster < this->Boxes.size(); ++cluster)
  {
    if (!this->Boxes[cluster].contains(point, margin))
    {
      continue;
    }
    for (std::size_t tet = cluster * TetsOfCluster; tet < endOfCluster(mesh, cluster); ++tet)
    {
      if (!mesh.isDegenerate(tet) && isAt(tet))
      {
        found.push_back(static_cast<Id>(tet));
      }
    }
  }
  return found;
}

} // namespace tetmarch
