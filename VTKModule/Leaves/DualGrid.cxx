// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Leaves/DualGrid.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{
namespace
{

vtkSmartPointer<vtkPoints> pointsOf(const Leaves& leaves, const std::vector<MixedPoint>& mixed)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(leaves.Shown + mixed.size()));
  vtkIdType next = 0;
  for (std::size_t i = 0; i < leaves.Shown; ++i)
  {
    points->SetPoint(next++, leaves.center(static_cast<int>(i)).data());
  }
  for (const MixedPoint& point : mixed)
  {
    points->SetPoint(next++, point.Position.data());
  }
  return points;
}

// The values of the leaves, then those that are mixed of them.
vtkSmartPointer<vtkDataArray> valuesOf(vtkDataArray* ofLeaves, const std::vector<MixedPoint>& mixed)
{
  auto values = vtkSmartPointer<vtkDataArray>::Take(ofLeaves->NewInstance());
  values->DeepCopy(ofLeaves);
  const vtkIdType leaves = ofLeaves->GetNumberOfTuples();
  values->Resize(leaves + static_cast<vtkIdType>(mixed.size()));
  values->SetNumberOfTuples(leaves + static_cast<vtkIdType>(mixed.size()));
  const bool whole = ofLeaves->GetDataType() != VTK_FLOAT && ofLeaves->GetDataType() != VTK_DOUBLE;
  vtkIdType next = leaves;
  for (const MixedPoint& point : mixed)
  {
    for (int c = 0; c < ofLeaves->GetNumberOfComponents(); ++c)
    {
      double value = 0;
      for (std::size_t i = 0; i < point.From.size(); ++i)
      {
        value += point.Weights[i] * ofLeaves->GetComponent(point.From[i], c);
      }
      values->SetComponent(next, c, whole ? std::round(value) : value);
    }
    ++next;
  }
  return values;
}

class CellWriter
{
public:
  explicit CellWriter(const DualCells& cells)
  {
    const std::size_t count = cells.Boxes.size() + cells.Pyramids.size() + cells.Tetrahedra.size();
    this->Offsets->SetNumberOfValues(static_cast<vtkIdType>(count + 1));
    this->Types->SetNumberOfValues(static_cast<vtkIdType>(count));
    this->Points->SetNumberOfValues(static_cast<vtkIdType>(
      8 * cells.Boxes.size() + 5 * cells.Pyramids.size() + 4 * cells.Tetrahedra.size()));
  }

  template <std::size_t N>
  void add(unsigned char type, const std::vector<std::array<int, N>>& cells)
  {
    for (const auto& cell : cells)
    {
      this->Offsets->SetValue(this->Cell, this->Place);
      this->Types->SetValue(this->Cell++, type);
      for (const int point : cell)
      {
        this->Points->SetValue(this->Place++, point);
      }
    }
  }

  void finish(vtkUnstructuredGrid* grid)
  {
    this->Offsets->SetValue(this->Cell, this->Place);
    vtkNew<vtkCellArray> cells;
    cells->SetData(this->Offsets, this->Points);
    grid->SetCells(this->Types, cells);
  }

private:
  vtkNew<vtkIdTypeArray> Offsets;
  vtkNew<vtkIdTypeArray> Points;
  vtkNew<vtkUnsignedCharArray> Types;
  vtkIdType Cell = 0;
  vtkIdType Place = 0;
};

} // namespace

void makeGrid(const Leaves& leaves, const DualCells& cells, vtkUnstructuredGrid* grid)
{
  grid->SetPoints(pointsOf(leaves, cells.Mixed));
  CellWriter writer(cells);
  writer.add(VTK_HEXAHEDRON, cells.Boxes);
  writer.add(VTK_PYRAMID, cells.Pyramids);
  writer.add(VTK_TETRA, cells.Tetrahedra);
  writer.finish(grid);
  for (vtkDataArray* array : leaves.Arrays)
  {
    grid->GetPointData()->AddArray(valuesOf(array, cells.Mixed));
  }
  grid->GetPointData()->SetActiveScalars(leaves.ActiveScalars.c_str());
}

} // namespace tetmarch
