// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/CornerScalars.h"

#include "Parallel/ParallelFor.h"

#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{

std::vector<Id> pointsOfSolids(const TetMesh& mesh)
{
  std::vector<Id> points;
  points.reserve(mesh.FirstPoints.size());
  for (std::size_t i = 0; i < mesh.FirstPoints.size(); ++i)
  {
    if (mesh.FirstPoints[i] != NoPoint)
    {
      points.push_back(static_cast<Id>(i));
    }
  }
  return points;
}

bool scalarsJump(const TetMesh& mesh, const std::vector<float>& ofPoints, float rounding)
{
  for (std::size_t i = 0; i < mesh.FirstPoints.size(); ++i)
  {
    const Id first = mesh.FirstPoints[i];
    if (first != NoPoint && std::abs(ofPoints[i] - ofPoints[first]) > rounding)
    {
      return true;
    }
  }
  return false;
}

float roundingOf(vtkDataArray* array, const ScalarRange& range)
{
  const double most = std::max(std::abs(range.Low), std::abs(range.High));
  const double ofArray = array->GetDataType() == VTK_FLOAT ? most / range.width() : 0;
  return static_cast<float>(std::ldexp(1 + ofArray, -23));
}

std::vector<std::array<float, 4>> cornerScalars(
  vtkPointSet* grid, const TetMesh& mesh, const std::vector<float>& ofPoints)
{
  std::vector<std::array<float, 4>> corners(mesh.Tets.size());
  parallelFor(0, static_cast<vtkIdType>(corners.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkNew<vtkIdList> points;
      for (vtkIdType t = begin; t < end; ++t)
      {
        grid->GetCellPoints(mesh.TetCells[t], points);
        for (std::size_t i = 0; i < 4; ++i)
        {
          const Id vertex = mesh.Tets[t][i];
          corners[t][i] = mesh.Vertices[vertex].Scalar;
          for (const vtkIdType point : *points)
          {
            if (mesh.FirstPoints[point] == mesh.VertexPoints[vertex])
            {
              corners[t][i] = ofPoints[point];
              break;
            }
          }
        }
      }
    });
  return corners;
}

} // namespace tetmarch
