// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FinerTetrahedra.h"

#include "vtkDataSetTriangleFilter.h"
#include "vtkNew.h"

#include <algorithm>
#include <map>
#include <utility>

namespace tetmarch::bench
{
namespace
{
constexpr int Corners = 4;

/// The points of a mesh, and those in the middle of its edges.
class Midpoints
{
public:
  explicit Midpoints(vtkPoints* points) { this->Points->DeepCopy(points); }

  vtkIdType between(vtkIdType a, vtkIdType b)
  {
    const auto [found, isNew] = this->Ids.try_emplace(std::minmax(a, b), 0);
    if (isNew)
    {
      double p[3], q[3];
      this->Points->GetPoint(a, p);
      this->Points->GetPoint(b, q);
      found->second = this->Points->InsertNextPoint(
        0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2]));
    }
    return found->second;
  }

  vtkPoints* points() const { return this->Points; }

private:
  vtkNew<vtkPoints> Points;
  std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> Ids;
};

/// One at each corner, and the octahedron that is left in four, around the line from the middle of
/// the edge 01 to that of 23.
void insertEight(const vtkIdType* corners, Midpoints& midpoints, vtkUnstructuredGrid* grid)
{
  const auto middle = [&](int i, int j) { return midpoints.between(corners[i], corners[j]); };
  const vtkIdType m01 = middle(0, 1), m02 = middle(0, 2), m03 = middle(0, 3), m12 = middle(1, 2),
                  m13 = middle(1, 3), m23 = middle(2, 3);
  const vtkIdType eight[][Corners] = { { corners[0], m01, m02, m03 }, { m01, corners[1], m12, m13 },
    { m02, m12, corners[2], m23 }, { m03, m13, m23, corners[3] }, { m01, m12, m02, m23 },
    { m01, m02, m03, m23 }, { m01, m03, m13, m23 }, { m01, m13, m12, m23 } };
  for (const auto& points : eight)
  {
    grid->InsertNextCell(VTK_TETRA, Corners, points);
  }
}
} // namespace

vtkSmartPointer<vtkUnstructuredGrid> finerTetrahedra(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkDataSetTriangleFilter> cut;
  cut->SetInputData(grid);
  cut->TetrahedraOnlyOn();
  cut->Update();
  vtkUnstructuredGrid* coarse = cut->GetOutput();
  Midpoints midpoints(coarse->GetPoints());
  auto fine = vtkSmartPointer<vtkUnstructuredGrid>::New();
  fine->Allocate(8 * coarse->GetNumberOfCells());
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < coarse->GetNumberOfCells(); ++cell)
  {
    coarse->GetCellPoints(cell, corners);
    insertEight(corners->GetPointer(0), midpoints, fine);
  }
  fine->SetPoints(midpoints.points());
  return fine;
}
} // namespace tetmarch::bench
