// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/MovedPoints.h"

#include "Input/PointCheck.h"
#include "Mesh/CoincidentPoints.h"
#include "Mesh/ConsistentOrientation.h"
#include "Mesh/Convexity.h"
#include "Mesh/HalfFaceLinks.h"
#include "Mesh/Orientation.h"
#include "Mesh/VertexPlaces.h"
#include "Parallel/ParallelFor.h"

#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace tetmarch
{
namespace
{

bool areSound(const Vector3& position)
{
  return std::all_of(position.begin(), position.end(), [](double x) { return isSound(x); });
}

bool moveVertices(vtkPoints* points, TetMesh& mesh)
{
  const std::vector<Vector3> positions = positionsOf(points, mesh);
  return std::all_of(positions.begin(), positions.end(), areSound) &&
         placeVertices(positions, mesh).empty();
}

int sideOf(const std::vector<std::int8_t>& signs, Id tet, Id i) { return signs[tet] * parity(i); }

// Whether the two tetrahedra of each link lie on opposite sides of their face.
bool agree(const TetMesh& mesh, const std::vector<std::int8_t>& signs)
{
  std::atomic<bool> agrees(true);
  parallelFor(0, static_cast<vtkIdType>(mesh.Tets.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (Id t = static_cast<Id>(first); t < static_cast<Id>(last); ++t)
      {
        bool opposite = signs[t] != 0;
        for (Id i = 0; i < 4; ++i)
        {
          const Id link = mesh.Links[4 * std::size_t(t) + i];
          opposite = opposite && (link >= LinkOutside ||
                                   sideOf(signs, t, i) * sideOf(signs, link / 4, link % 4) < 0);
        }
        if (!opposite)
        {
          agrees = false;
          return;
        }
      }
    });
  return agrees;
}

// In the order of buildTetMesh(): by the smallest vertex.
void turnBoundary(const std::vector<std::int8_t>& signs, TetMesh& mesh)
{
  std::vector<std::pair<Id, Id>> halfFaces;
  halfFaces.reserve(mesh.BoundaryFaces.size());
  for (const auto& face : mesh.BoundaryFaces)
  {
    const Id halfFace = face[3];
    halfFaces.emplace_back(mesh.Tets[halfFace / 4][halfFace % 4 == 0 ? 1 : 0], halfFace);
  }
  std::sort(halfFaces.begin(), halfFaces.end());
  for (std::size_t b = 0; b < halfFaces.size(); ++b)
  {
    const Id halfFace = halfFaces[b].second;
    mesh.BoundaryFaces[b] = outwardFace(mesh, halfFace, signs[halfFace / 4]);
  }
}

} // namespace

bool movePoints(vtkUnstructuredGrid* grid, TetMesh& mesh)
{
  vtkPoints* points = grid->GetPoints();
  if (!mesh.LinksFollowCells || !points || points->GetData()->GetNumberOfComponents() != 3 ||
      points->GetNumberOfPoints() != mesh.NumberOfPoints ||
      findCoincidentPoints(grid, false) != mesh.FirstPoints || !moveVertices(points, mesh))
  {
    return false;
  }
  const std::vector<std::int8_t> signs = volumeSigns(mesh);
  if (!agree(mesh, signs))
  {
    return false;
  }
  turnBoundary(signs, mesh);
  mesh.Hierarchy.clear();
  mesh.ReentryNodes = 0;
  mesh.ReentryFaces = 0;
  mesh.MayReenter = !isConvex(mesh);
  linkBoundary(mesh);
  return true;
}

} // namespace tetmarch
