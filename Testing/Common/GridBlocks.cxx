// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GridBlocks.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCompositeDataIterator.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <stdexcept>

namespace tetmarch::testing
{
namespace
{
struct Parts
{
  std::vector<Ids> Cells;
  std::vector<Ids> Points;
};

Parts partsOf(vtkUnstructuredGrid* grid, const BlockOf& blockOf)
{
  Parts parts;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCellPoints(cell, ids);
    Vec3 centre{};
    for (const vtkIdType id : *ids)
    {
      for (int k = 0; k < 3; ++k)
      {
        centre[k] += grid->GetPoint(id)[k] / static_cast<double>(ids->GetNumberOfIds());
      }
    }
    const auto part = static_cast<std::size_t>(blockOf(centre));
    parts.Cells.resize(std::max(parts.Cells.size(), part + 1));
    parts.Points.resize(parts.Cells.size());
    parts.Cells[part].push_back(cell);
    parts.Points[part].insert(parts.Points[part].end(), ids->begin(), ids->end());
  }
  for (Ids& points : parts.Points)
  {
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
  }
  return parts;
}

vtkSmartPointer<vtkDoubleArray> valuesOf(vtkDataArray* array, const Ids& ids)
{
  auto values = vtkSmartPointer<vtkDoubleArray>::New();
  values->SetName(array->GetName());
  for (const vtkIdType id : ids)
  {
    values->InsertNextValue(array->GetComponent(id, 0));
  }
  return values;
}

vtkIdType newIdOf(const Ids& points, vtkIdType id)
{
  return std::lower_bound(points.begin(), points.end(), id) - points.begin();
}

void copyCell(vtkUnstructuredGrid* from, vtkIdType cell, const Ids& points, vtkUnstructuredGrid* to)
{
  vtkNew<vtkIdList> ids;
  if (from->GetCellType(cell) == VTK_POLYHEDRON)
  {
    from->GetFaceStream(cell, ids);
    vtkIdType at = 1;
    while (at < ids->GetNumberOfIds())
    {
      for (vtkIdType corners = ids->GetId(at++); corners > 0; --corners, ++at)
      {
        ids->SetId(at, newIdOf(points, ids->GetId(at)));
      }
    }
  }
  else
  {
    from->GetCellPoints(cell, ids);
    for (vtkIdType& id : *ids)
    {
      id = newIdOf(points, id);
    }
  }
  to->InsertNextCell(from->GetCellType(cell), ids);
}
} // namespace

BlockOf partsOfUnitCube(int count)
{
  switch (count)
  {
    case 2:
      return [](const Vec3& x) { return x[0] < 0.5 ? 0 : 1; };
    case 3:
      return [](const Vec3& x) { return std::min(static_cast<int>(3.0 * x[1]), 2); };
    case 8:
      return [](const Vec3& x)
      { return (x[0] < 0.5 ? 0 : 1) + (x[1] < 0.5 ? 0 : 2) + (x[2] < 0.5 ? 0 : 4); };
    default:
      throw std::invalid_argument("2, 3 or 8 blocks");
  }
}

std::vector<Grid> cutIntoBlocks(
  vtkUnstructuredGrid* grid, const BlockOf& blockOf, bool withGlobalIds)
{
  const Parts parts = partsOf(grid, blockOf);
  std::vector<Grid> result;
  for (std::size_t part = 0; part < parts.Cells.size(); ++part)
  {
    auto block = Grid::New();
    vtkNew<vtkPoints> points;
    points->SetDataType(grid->GetPoints()->GetDataType());
    vtkNew<vtkIdTypeArray> globalIds;
    globalIds->SetName("ids");
    for (const vtkIdType id : parts.Points[part])
    {
      points->InsertNextPoint(grid->GetPoint(id));
      globalIds->InsertNextValue(id);
    }
    block->SetPoints(points);
    for (const vtkIdType cell : parts.Cells[part])
    {
      copyCell(grid, cell, parts.Points[part], block);
    }
    block->GetPointData()->SetScalars(
      valuesOf(grid->GetPointData()->GetScalars(), parts.Points[part]));
    block->GetCellData()->SetScalars(
      valuesOf(grid->GetCellData()->GetScalars(), parts.Cells[part]));
    if (withGlobalIds)
    {
      block->GetPointData()->SetGlobalIds(globalIds);
    }
    result.push_back(block);
  }
  return result;
}

vtkSmartPointer<vtkMultiBlockDataSet> blocks(const std::vector<Grid>& grids)
{
  auto result = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (std::size_t b = 0; b < grids.size(); ++b)
  {
    result->SetBlock(static_cast<unsigned>(b), grids[b]);
  }
  return result;
}

vtkDataSet* blockAt(vtkCompositeDataSet* data, unsigned int flatIndex)
{
  const auto at = vtk::TakeSmartPointer(data->NewIterator());
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
  {
    if (at->GetCurrentFlatIndex() == flatIndex)
    {
      return vtkDataSet::SafeDownCast(at->GetCurrentDataObject());
    }
  }
  return nullptr;
}
} // namespace tetmarch::testing
