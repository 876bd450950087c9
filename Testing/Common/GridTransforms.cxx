// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GridTransforms.h"

#include "CubeTopology.h"
#include "LatticeGrids.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <utility>

namespace tetmarch::testing
{
namespace
{
// Fisher and Yates; std::shuffle may draw differently on every platform.
template <typename Container>
void shuffle(Container& values, std::mt19937& generator)
{
  for (std::size_t left = values.size(); left > 1; --left)
  {
    std::swap(values[left - 1], values[generator() % left]);
  }
}

Ids randomOrder(vtkIdType count, std::mt19937& generator)
{
  Ids order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  shuffle(order, generator);
  return order;
}

void copyInOrder(vtkDataSetAttributes* from, vtkDataSetAttributes* to, const Ids& order)
{
  const auto count = static_cast<vtkIdType>(order.size());
  to->CopyAllOn();
  to->CopyAllocate(from, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    to->CopyData(from, order[i], i);
  }
}

Grid shallowCopy(vtkUnstructuredGrid* grid)
{
  auto copy = Grid::New();
  copy->ShallowCopy(grid);
  return copy;
}

void append(vtkDataArray* values, vtkDoubleArray* to)
{
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    to->InsertNextValue(values->GetComponent(i, 0));
  }
}
} // namespace

Grid shuffled(vtkUnstructuredGrid* grid, unsigned seed)
{
  std::mt19937 generator(seed);
  const Ids pointOrder = randomOrder(grid->GetNumberOfPoints(), generator);
  const Ids cellOrder = randomOrder(grid->GetNumberOfCells(), generator);

  Ids newId(pointOrder.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(grid->GetNumberOfPoints());
  for (std::size_t i = 0; i < pointOrder.size(); ++i)
  {
    newId[pointOrder[i]] = static_cast<vtkIdType>(i);
    double p[3];
    grid->GetPoint(pointOrder[i], p);
    points->SetPoint(static_cast<vtkIdType>(i), p);
  }

  auto result = Grid::New();
  result->SetPoints(points);
  result->Allocate(grid->GetNumberOfCells());
  vtkNew<vtkIdList> ids;
  for (const vtkIdType cell : cellOrder)
  {
    grid->GetCells()->GetCellAtId(cell, ids);
    std::array<vtkIdType, 4> tet;
    for (int k = 0; k < 4; ++k)
    {
      tet[k] = newId[ids->GetId(k)];
    }
    shuffle(tet, generator);
    result->InsertNextCell(VTK_TETRA, 4, tet.data());
  }
  copyInOrder(grid->GetPointData(), result->GetPointData(), pointOrder);
  copyInOrder(grid->GetCellData(), result->GetCellData(), cellOrder);
  return result;
}

Grid withOffsetAndScale(vtkUnstructuredGrid* grid, const Vec3& offset, double scale)
{
  Grid result = shallowCopy(grid);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(grid->GetNumberOfPoints());
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    double p[3];
    grid->GetPoint(i, p);
    points->SetPoint(
      i, offset[0] + scale * p[0], offset[1] + scale * p[1], offset[2] + scale * p[2]);
  }
  result->SetPoints(points);
  return result;
}

Grid withFloatPoints(vtkUnstructuredGrid* grid)
{
  Grid result = shallowCopy(grid);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->DeepCopy(grid->GetPoints());
  result->SetPoints(points);
  return result;
}

Grid withCells32(vtkUnstructuredGrid* grid)
{
  auto result = Grid::New();
  result->DeepCopy(grid);
  result->GetCells()->ConvertTo32BitStorage();
  return result;
}

Grid withRepeatedPoints(vtkUnstructuredGrid* grid)
{
  auto result = Grid::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(grid->GetPoints()->GetDataType());
  Ids origins;
  std::map<vtkIdType, vtkIdType> ofCell;
  const auto repeat = [&](vtkIdList* ids, vtkIdType at)
  {
    const auto added = ofCell.try_emplace(ids->GetId(at), points->GetNumberOfPoints());
    if (added.second)
    {
      origins.push_back(ids->GetId(at));
      points->InsertNextPoint(grid->GetPoint(ids->GetId(at)));
    }
    ids->SetId(at, added.first->second);
  };
  result->Allocate(grid->GetNumberOfCells());
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    ofCell.clear();
    if (grid->GetCellType(cell) == VTK_POLYHEDRON)
    {
      grid->GetFaceStream(cell, ids);
      vtkIdType at = 1;
      for (vtkIdType face = 0; face < ids->GetId(0); ++face)
      {
        for (vtkIdType corners = ids->GetId(at++); corners > 0; --corners)
        {
          repeat(ids, at++);
        }
      }
    }
    else
    {
      grid->GetCellPoints(cell, ids);
      for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
      {
        repeat(ids, i);
      }
    }
    result->InsertNextCell(grid->GetCellType(cell), ids);
  }
  result->SetPoints(points);
  copyInOrder(grid->GetPointData(), result->GetPointData(), origins);
  result->GetCellData()->ShallowCopy(grid->GetCellData());
  return result;
}

Grid withJumps(vtkUnstructuredGrid* grid, double most, unsigned seed)
{
  Grid result = withRepeatedPoints(grid);
  std::mt19937 generator(seed);
  vtkDataArray* f = result->GetPointData()->GetScalars();
  for (vtkIdType i = f->GetNumberOfTuples() / 2; i < f->GetNumberOfTuples(); ++i)
  {
    f->SetComponent(i, 0, f->GetComponent(i, 0) + most * (2.0 * uniform(generator) - 1.0));
  }
  return result;
}

Grid inTetrahedra(vtkUnstructuredGrid* hexahedra)
{
  auto result = Grid::New();
  result->SetPoints(hexahedra->GetPoints());
  vtkDataArray* values = hexahedra->GetCellData()->GetArray("c");
  vtkUnsignedCharArray* ghosts = hexahedra->GetCellGhostArray();
  vtkNew<vtkDoubleArray> ofTets;
  ofTets->SetName("c");
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < hexahedra->GetNumberOfCells(); ++cell)
  {
    if (ghosts && ghosts->GetValue(cell) != 0)
    {
      continue;
    }
    hexahedra->GetCellPoints(cell, ids);
    for (const auto& corners : KuhnTets)
    {
      vtkIdType tet[4];
      std::transform(std::begin(corners), std::end(corners), tet,
        [&](int corner) { return ids->GetId(HexCorners[corner]); }); // its own inverse
      result->InsertNextCell(VTK_TETRA, 4, tet);
      ofTets->InsertNextValue(values->GetComponent(cell, 0));
    }
  }
  result->GetPointData()->ShallowCopy(hexahedra->GetPointData());
  result->GetCellData()->SetScalars(ofTets);
  return result;
}

Grid joined(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b)
{
  auto result = Grid::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> f;
  f->SetName("f");
  vtkNew<vtkDoubleArray> c;
  c->SetName("c");
  result->SetPoints(points);
  result->Allocate(a->GetNumberOfCells() + b->GetNumberOfCells());
  vtkNew<vtkIdList> ids;
  for (vtkUnstructuredGrid* grid : { a, b })
  {
    const vtkIdType first = points->GetNumberOfPoints();
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      points->InsertNextPoint(grid->GetPoint(i));
    }
    for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
    {
      grid->GetCells()->GetCellAtId(i, ids);
      for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
      {
        ids->SetId(k, first + ids->GetId(k));
      }
      result->InsertNextCell(grid->GetCellType(i), ids);
    }
    append(grid->GetPointData()->GetArray("f"), f);
    append(grid->GetCellData()->GetArray("c"), c);
  }
  result->GetPointData()->SetScalars(f);
  result->GetCellData()->SetScalars(c);
  return result;
}
} // namespace tetmarch::testing
