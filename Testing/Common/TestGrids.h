// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TestGrids_h
#define TestGrids_h

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <vector>

/// One unit voxel with its lowest corner at (x, 0, 0).
inline vtkSmartPointer<vtkUnstructuredGrid> MakeVoxel(double x)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  vtkIdType ids[8];
  for (int i = 0; i < 8; ++i)
  {
    ids[i] = points->InsertNextPoint(x + (i & 1), i >> 1 & 1, i >> 2 & 1);
  }
  grid->SetPoints(points);
  grid->InsertNextCell(VTK_VOXEL, 8, ids);
  return grid;
}

/// Two unit voxels side by side along x.
inline vtkSmartPointer<vtkUnstructuredGrid> MakeTwoVoxels()
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 12; ++i)
  {
    points->InsertNextPoint(i % 3, i / 3 % 2, i / 6);
  }
  grid->SetPoints(points);
  for (const vtkIdType x : { 0, 1 })
  {
    const vtkIdType ids[8] = { x, x + 1, x + 3, x + 4, x + 6, x + 7, x + 9, x + 10 };
    grid->InsertNextCell(VTK_VOXEL, 8, ids);
  }
  return grid;
}

inline vtkSmartPointer<vtkDoubleArray> MakeCoordinates(const std::vector<double>& values)
{
  auto coordinates = vtkSmartPointer<vtkDoubleArray>::New();
  for (double value : values)
  {
    coordinates->InsertNextValue(value);
  }
  return coordinates;
}

/// Two cells along x, of widths 1 and 3, one along y of 2, three along z of 1.
inline vtkSmartPointer<vtkRectilinearGrid> MakeThreeLayers()
{
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  grid->SetDimensions(3, 2, 4);
  grid->SetXCoordinates(MakeCoordinates({ 0, 1, 4 }));
  grid->SetYCoordinates(MakeCoordinates({ -1, 1 }));
  grid->SetZCoordinates(MakeCoordinates({ 3, 4, 5, 6 }));
  return grid;
}

/// An array of the given type; tuple i is (i, i, ...) if it varies, else 0.
template <typename Array>
void AddArray(vtkDataSetAttributes* attributes, const char* name, vtkIdType tuples,
  int components = 1, bool varies = true)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  for (vtkIdType i = 0; i < tuples * components; ++i)
  {
    array->SetValue(i, varies ? static_cast<typename Array::ValueType>(i / components) : 0);
  }
  attributes->AddArray(array);
}

#endif
