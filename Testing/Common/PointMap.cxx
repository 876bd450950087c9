// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointMap.h"

#include "vtkNew.h"
#include "vtkPoints.h"

#include <cmath>

namespace tetmarch::testing
{
Grid mapped(vtkUnstructuredGrid* grid, const PointMap& map)
{
  auto result = Grid::New();
  result->ShallowCopy(grid);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(grid->GetNumberOfPoints());
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    Vec3 p;
    grid->GetPoint(i, p.data());
    points->SetPoint(i, map(p, i).data());
  }
  result->SetPoints(points);
  return result;
}

Grid rounded(vtkUnstructuredGrid* grid, double step)
{
  const auto round = [step](double x) { return std::floor(x / step + 0.5) * step; };
  return mapped(grid,
    [round](const Vec3& p, vtkIdType) {
      return Vec3{ round(p[0]), round(p[1]), round(p[2]) };
    });
}
} // namespace tetmarch::testing
