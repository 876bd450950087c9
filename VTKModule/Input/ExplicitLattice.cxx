// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/ExplicitLattice.h"

#include "Caching/WithinMemory.h"
#include "Input/DataCheck.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkExplicitStructuredGrid.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace tetmarch
{
namespace
{

constexpr vtkIdType NoPoint = -1;

// Where the corners of a hexahedron lie along i, j and k, in VTK's order.
constexpr int Corners[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
  { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };

Fingerprint cellsOf(vtkExplicitStructuredGrid* grid)
{
  Fingerprint version;
  add(version, grid->GetPoints());
  add(version, static_cast<vtkObject*>(grid->GetCells()));
  const int* extent = grid->GetExtent();
  std::for_each(
    extent, extent + 6, [&](int end) { version.push_back(static_cast<std::uintptr_t>(end)); });
  version.push_back(grid->GetPointData()->GetNumberOfArrays() > 0 ? 1 : 0);
  return version;
}

Fingerprint arraysOf(vtkExplicitStructuredGrid* grid)
{
  Fingerprint version;
  add(version, grid->GetPointData());
  add(version, grid->GetCellData());
  return version;
}

std::array<vtkIdType, 3> pointsAlong(vtkExplicitStructuredGrid* grid)
{
  const int* extent = grid->GetExtent();
  return { { vtkIdType(extent[1]) - extent[0] + 1, vtkIdType(extent[3]) - extent[2] + 1,
    vtkIdType(extent[5]) - extent[4] + 1 } };
}

} // namespace

vtkStructuredGrid* ExplicitLattice::curvilinearOf(vtkDataObject* input)
{
  auto* grid = vtkExplicitStructuredGrid::SafeDownCast(input);
  if (!grid)
  {
    *this = {};
    return vtkStructuredGrid::SafeDownCast(input);
  }
  const std::string shortage = withinMemory("the points of an explicit grid",
    [&]
    {
      const Fingerprint cells = cellsOf(grid);
      if (cells != this->Cells)
      {
        *this = {};
        if (!checkData(grid).empty() || !this->findPoints(grid))
        {
          this->Points.clear();
        }
        this->Cells = cells;
      }
      const Fingerprint arrays = arraysOf(grid);
      if (!this->Points.empty() && arrays != this->Arrays)
      {
        this->copyAttributes(grid);
        this->Arrays = arrays;
      }
    });
  if (!shortage.empty())
  {
    *this = {}; // as a grid of cells it is tried again, and the shortage told
  }
  return this->Points.empty() ? nullptr : this->Made.Get();
}

// False if the cells are not those of a lattice of points.
bool ExplicitLattice::findPoints(vtkExplicitStructuredGrid* grid)
{
  const std::array<vtkIdType, 3> n = pointsAlong(grid);
  if (std::any_of(n.begin(), n.end(), [](vtkIdType along) { return along < 2; }) ||
      grid->GetNumberOfCells() != (n[0] - 1) * (n[1] - 1) * (n[2] - 1))
  {
    return false;
  }
  this->Points.assign(static_cast<std::size_t>(n[0] * n[1] * n[2]), NoPoint);
  vtkPoints* places = grid->GetPoints();
  const bool mayRepeat = grid->GetPointData()->GetNumberOfArrays() == 0;
  const auto isSame = [&](vtkIdType p, vtkIdType q)
  {
    std::array<double, 3> a, b;
    places->GetPoint(p, a.data());
    places->GetPoint(q, b.data());
    return mayRepeat && a == b;
  };
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const vtkIdType i = cell % (n[0] - 1);
    const vtkIdType j = cell / (n[0] - 1) % (n[1] - 1);
    const vtkIdType k = cell / (n[0] - 1) / (n[1] - 1);
    grid->GetCells()->GetCellAtId(cell, ids);
    for (int corner = 0; corner < 8; ++corner)
    {
      const auto& c = Corners[corner];
      vtkIdType& point = this->Points[i + c[0] + n[0] * (j + c[1] + n[1] * (k + c[2]))];
      const vtkIdType own = ids->GetId(corner);
      if (point != NoPoint && point != own && !isSame(point, own))
      {
        return false;
      }
      point = point == NoPoint ? own : point;
    }
  }
  this->Made = vtkSmartPointer<vtkStructuredGrid>::New();
  this->Made->SetDimensions(static_cast<int>(n[0]), static_cast<int>(n[1]), static_cast<int>(n[2]));
  vtkNew<vtkPoints> points;
  points->SetDataType(places->GetDataType());
  points->SetNumberOfPoints(static_cast<vtkIdType>(this->Points.size()));
  for (std::size_t vertex = 0; vertex < this->Points.size(); ++vertex)
  {
    points->SetPoint(static_cast<vtkIdType>(vertex), places->GetPoint(this->Points[vertex]));
  }
  this->Made->SetPoints(points);
  return true;
}

void ExplicitLattice::copyAttributes(vtkExplicitStructuredGrid* grid)
{
  this->Made->GetCellData()->ShallowCopy(grid->GetCellData());
  vtkPointData* from = grid->GetPointData();
  vtkPointData* to = this->Made->GetPointData();
  const auto count = static_cast<vtkIdType>(this->Points.size());
  vtkNew<vtkIdList> ids;
  vtkNew<vtkIdList> vertices;
  ids->SetNumberOfIds(count);
  vertices->SetNumberOfIds(count);
  std::copy(this->Points.begin(), this->Points.end(), ids->begin());
  std::iota(vertices->begin(), vertices->end(), vtkIdType(0));
  to->Initialize();
  to->CopyAllOn();
  to->CopyAllocate(from, count);
  to->SetNumberOfTuples(count);
  to->CopyData(from, ids, vertices);
}

} // namespace tetmarch
