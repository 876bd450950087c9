// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Actors without a window
 */
#ifndef tetmarch_testing_OpaqueProps_h
#define tetmarch_testing_OpaqueProps_h

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkSmartPointer.h"

#include <array>

namespace tetmarch::testing
{
/// One quadrilateral; its fourth corner, with the number 3, is a + b - corner.
inline vtkSmartPointer<vtkPolyData> plate(const std::array<double, 3>& corner,
  const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(corner.data());
  points->InsertNextPoint(a.data());
  points->InsertNextPoint(b.data());
  points->InsertNextPoint(
    a[0] + b[0] - corner[0], a[1] + b[1] - corner[1], a[2] + b[2] - corner[2]);
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 1, 3, 2 });
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(polygons);
  return data;
}

inline vtkSmartPointer<vtkActor> actorOf(vtkPolyData* data)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}
} // namespace tetmarch::testing

#endif
