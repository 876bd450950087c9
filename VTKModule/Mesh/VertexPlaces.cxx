// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/VertexPlaces.h"

#include "Parallel/ParallelFor.h"

#include "vtkPoints.h"

namespace tetmarch
{

std::vector<Vector3> positionsOf(vtkPoints* points, const TetMesh& mesh)
{
  std::vector<Vector3> positions(mesh.VertexPoints.size());
  parallelFor(0, static_cast<vtkIdType>(positions.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        points->GetPoint(mesh.VertexPoints[i], positions[i].data());
      }
    });
  return positions;
}

std::string placeVertices(const std::vector<Vector3>& positions, TetMesh& mesh)
{
  std::string wrong = findFrame(positions, mesh.Frame);
  if (wrong.empty())
  {
    mesh.Vertices.resize(positions.size());
    parallelFor(0, static_cast<vtkIdType>(positions.size()),
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          mesh.Vertices[i] = vertexAt(positions[i], mesh.Frame);
        }
      });
  }
  return wrong;
}

} // namespace tetmarch
