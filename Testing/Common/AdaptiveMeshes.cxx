// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AdaptiveMeshes.h"

#include "vtkAMRBox.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkOverlappingAMR.h"
#include "vtkPoints.h"
#include "vtkStructuredData.h"
#include "vtkUniformGrid.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <array>
#include <vector>

namespace tetmarch::testing
{
namespace
{
constexpr int Coarse = 4; // cells along an edge of the cube; twice as many on each further level

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 6, 0)
using BlockCount = int;
#else
using BlockCount = unsigned int;
#endif

struct Box
{
  int Level;
  std::array<int, 3> Low, High; // cells of the level, inclusive
};

// On level 1 two blocks beside each other and one in a corner, on level 2 one that reaches the
// border of the first.
const std::vector<Box> Boxes = {
  { 0, { 0, 0, 0 }, { 3, 3, 3 } },
  { 1, { 2, 2, 2 }, { 3, 5, 5 } },
  { 1, { 4, 2, 2 }, { 5, 5, 5 } },
  { 1, { 0, 0, 0 }, { 3, 3, 1 } },
  { 1, { 6, 6, 6 }, { 7, 7, 7 } },
  { 2, { 4, 6, 6 }, { 7, 11, 11 } },
  { 2, { 12, 12, 12 }, { 15, 13, 13 } },
};

double widthOf(int level) { return 1.0 / (Coarse << level); }

double valueIn(const Field& field, int level, const std::array<int, 3>& cell)
{
  const double h = widthOf(level);
  return field(h * (cell[0] + 0.5), h * (cell[1] + 0.5), h * (cell[2] + 0.5));
}

vtkSmartPointer<vtkUniformGrid> blockOf(const Box& box, const Field& field)
{
  auto block = vtkSmartPointer<vtkUniformGrid>::New();
  const double h = widthOf(box.Level);
  block->SetOrigin(h * box.Low[0], h * box.Low[1], h * box.Low[2]);
  block->SetSpacing(h, h, h);
  block->SetDimensions(
    box.High[0] - box.Low[0] + 2, box.High[1] - box.Low[1] + 2, box.High[2] - box.Low[2] + 2);
  vtkNew<vtkDoubleArray> values;
  values->SetName("c");
  for (int k = box.Low[2]; k <= box.High[2]; ++k)
  {
    for (int j = box.Low[1]; j <= box.High[1]; ++j)
    {
      for (int i = box.Low[0]; i <= box.High[0]; ++i)
      {
        values->InsertNextValue(valueIn(field, box.Level, { i, j, k }));
      }
    }
  }
  block->GetCellData()->SetScalars(values);
  return block;
}

// The cell of its finest level that contains the cell of level 2.
double finestValue(const Field& field, const std::array<int, 3>& fine)
{
  int level = 0;
  for (const Box& box : Boxes)
  {
    bool inside = true;
    for (int a = 0; a < 3; ++a)
    {
      const int cell = fine[a] >> (2 - box.Level);
      inside = inside && cell >= box.Low[a] && cell <= box.High[a];
    }
    level = inside ? std::max(level, box.Level) : level;
  }
  const int shift = 2 - level;
  return valueIn(field, level, { fine[0] >> shift, fine[1] >> shift, fine[2] >> shift });
}
} // namespace

vtkSmartPointer<vtkOverlappingAMR> adaptiveMesh(const Field& field)
{
  auto mesh = vtkSmartPointer<vtkOverlappingAMR>::New();
  std::array<BlockCount, 3> counts{};
  for (const Box& box : Boxes)
  {
    ++counts[box.Level];
  }
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 6, 0)
  mesh->Initialize(3, counts.data());
#else
  mesh->Initialize({ counts.begin(), counts.end() });
#endif
  const double origin[3] = { 0, 0, 0 };
  mesh->SetOrigin(origin);
  int points[3] = { 2, 2, 2 }; // of three axes
  mesh->SetGridDescription(vtkStructuredData::GetDataDescription(points));
  std::array<unsigned int, 3> next{};
  for (const Box& box : Boxes)
  {
    const double h = widthOf(box.Level);
    const double spacing[3] = { h, h, h };
    const auto level = static_cast<unsigned int>(box.Level);
    mesh->SetSpacing(level, spacing);
    mesh->SetAMRBox(level, next[level], vtkAMRBox(box.Low.data(), box.High.data()));
    mesh->SetDataSet(level, next[level]++, blockOf(box, field));
  }
  return mesh;
}

Grid evenMesh(const Field& field)
{
  constexpr int n = 4 * Coarse, row = n + 1, layer = row * row;
  auto grid = Grid::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> values;
  values->SetName("c");
  for (int p = 0; p < layer * row; ++p)
  {
    points->InsertNextPoint(double(p % row) / n, double(p / row % row) / n, double(p / layer) / n);
  }
  grid->SetPoints(points);
  for (int c = 0; c < n * n * n; ++c)
  {
    const std::array<int, 3> cell{ { c % n, c / n % n, c / (n * n) } };
    const vtkIdType low = cell[0] + row * cell[1] + layer * cell[2], high = low + layer;
    const vtkIdType ids[8] = { low, low + 1, low + 1 + row, low + row, high, high + 1,
      high + 1 + row, high + row };
    grid->InsertNextCell(VTK_HEXAHEDRON, 8, ids);
    values->InsertNextValue(finestValue(field, cell));
  }
  grid->GetCellData()->SetScalars(values);
  return grid;
}
} // namespace tetmarch::testing
