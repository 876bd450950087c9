// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pieces.h"

#include "vtkIdList.h"
#include "vtkPoints.h"

#include <algorithm>
#include <map>
#include <random>

namespace tetmarch
{
namespace testing
{

Partition randomPartition(int processes, unsigned int seed)
{
  return [=](vtkIdType cell)
  {
    std::mt19937 random(seed + static_cast<unsigned int>(cell) * 7919u);
    return static_cast<int>(random() % static_cast<unsigned int>(processes));
  };
}

Grid pieceOf(vtkUnstructuredGrid* grid, const Partition& partition, int process)
{
  const auto piece = Grid::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(grid->GetPoints()->GetDataType());
  std::map<vtkIdType, vtkIdType> numbers;
  const auto numberOf = [&](vtkIdType point)
  {
    const auto [at, isNew] = numbers.try_emplace(point, points->GetNumberOfPoints());
    if (isNew)
    {
      points->InsertNextPoint(grid->GetPoint(point));
    }
    return at->second;
  };
  piece->Allocate(grid->GetNumberOfCells());
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = grid->GetNumberOfCells() - 1; cell >= 0; --cell)
  {
    if (partition(cell) != process)
    {
      continue;
    }
    if (grid->GetCellType(cell) != VTK_POLYHEDRON)
    {
      grid->GetCellPoints(cell, ids);
      std::transform(ids->begin(), ids->end(), ids->begin(), numberOf);
    }
    else
    {
      grid->GetFaceStream(cell, ids);
      for (vtkIdType at = 1; at < ids->GetNumberOfIds();)
      {
        const vtkIdType end = at + 1 + ids->GetId(at);
        std::transform(ids->begin() + at + 1, ids->begin() + end, ids->begin() + at + 1, numberOf);
        at = end;
      }
    }
    piece->InsertNextCell(grid->GetCellType(cell), ids);
  }
  piece->SetPoints(points);
  return piece;
}

} // namespace testing
} // namespace tetmarch
