// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BrokenGrids.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <cmath>

namespace tetmarch::testing
{
Grid movedPoints(vtkUnstructuredGrid* grid, const std::function<Vec3(const Vec3&, vtkIdType)>& to)
{
  auto moved = Grid::New();
  moved->ShallowCopy(grid);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    Vec3 p;
    grid->GetPoint(i, p.data());
    points->InsertNextPoint(to(p, i).data());
  }
  moved->SetPoints(points);
  return moved;
}

Grid withTets(vtkUnstructuredGrid* grid, const std::vector<Ids>& tets)
{
  auto made = Grid::New();
  made->SetPoints(grid->GetPoints());
  made->GetPointData()->ShallowCopy(grid->GetPointData());
  made->Allocate(static_cast<vtkIdType>(tets.size()));
  vtkDataArray* scalars = grid->GetPointData()->GetScalars();
  const auto cells = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(VTK_DOUBLE));
  cells->SetName("c");
  for (const Ids& tet : tets)
  {
    made->InsertNextCell(VTK_TETRA, 4, tet.data());
    double sum = 0.0;
    for (const vtkIdType point : tet)
    {
      sum += 0.25 * scalars->GetComponent(point, 0);
    }
    cells->InsertNextTuple1(sum);
  }
  made->GetCellData()->SetScalars(cells);
  return made;
}

std::vector<Ids> tetsOf(vtkUnstructuredGrid* grid)
{
  std::vector<Ids> tets;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    vtkIdType count;
    const vtkIdType* ids;
    grid->GetCells()->GetCellAtId(c, count, ids);
    tets.emplace_back(ids, ids + count);
  }
  return tets;
}

Grid needleFan(int count, double radius, const Field& field)
{
  GridBuilder builder;
  builder.addPoint({ 0.0, 0.0, 0.0 });
  builder.addPoint({ 0.0, 0.0, 1.0 });
  for (int i = 0; i < count; ++i)
  {
    const double angle = 6.283185307179586 * i / count;
    builder.addPoint({ radius * std::cos(angle), radius * std::sin(angle), 0.5 });
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    builder.addCell(VTK_TETRA, { 0, 1, 2 + i, 2 + (i + 1) % count });
  }
  return builder.finish(field);
}

Grid moebiusRing(int prisms, const Field& field)
{
  GridBuilder builder;
  for (int i = 0; i < prisms; ++i)
  {
    const double angle = 6.283185307179586 * i / prisms;
    for (int corner = 0; corner < 3; ++corner)
    {
      const double turn = 2.0943951023931953 * corner;
      const double ring = 1.0 + 0.3 * std::cos(turn);
      builder.addPoint({ ring * std::cos(angle), ring * std::sin(angle), 0.3 * std::sin(turn) });
    }
  }
  for (vtkIdType i = 0; i < prisms; ++i)
  {
    const vtkIdType a = 3 * i, b = a + 1, c = a + 2;
    const bool last = i + 1 == prisms;
    const vtkIdType d = last ? 0 : a + 3;
    const vtkIdType e = last ? 2 : b + 3;
    const vtkIdType f = last ? 1 : c + 3;
    builder.addCell(VTK_TETRA, { a, b, c, d });
    builder.addCell(VTK_TETRA, { b, c, d, e });
    builder.addCell(VTK_TETRA, { c, d, e, f });
  }
  return builder.finish(field);
}

Grid tetsOnOneFace(int above, int below, const Field& field)
{
  GridBuilder builder;
  builder.addPoint({ 0.0, 0.0, 0.5 });
  builder.addPoint({ 1.0, 0.1, 0.5 });
  builder.addPoint({ 0.2, 1.0, 0.5 });
  for (int i = 0; i < above + below; ++i)
  {
    const double share = (i + 0.5) / (above + below);
    const double height = i < above ? 0.4 : -0.4;
    const vtkIdType tip = builder.addPoint({ share, 0.7 * share, 0.5 + height * (0.5 + share) });
    builder.addCell(VTK_TETRA, { 0, 1, 2, tip });
  }
  return builder.finish(field);
}
} // namespace tetmarch::testing
