// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CurvilinearGrids.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace tetmarch::testing
{
namespace
{
// About the axis (0.5, 0.5, z), by turns from the x axis on; a whole turn ends where it began.
Vec3 turned(double radius, double turns, double z)
{
  const double angle = 2 * vtkMath::Pi() * (turns - std::floor(turns));
  return { 0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle), z };
}

Vec3 onSphere(double radius, double turns, double share)
{
  const double angle = vtkMath::Pi() * share;
  return turned(share < 1 ? radius * std::sin(angle) : 0.0, turns, 0.5 - radius * std::cos(angle));
}

Vec3 onTorus(double radius, double turns, double aroundTube)
{
  const Vec3 tube = turned(radius, aroundTube, 0);
  return turned(tube[0] - 0.2, turns, tube[1]);
}
} // namespace

vtkSmartPointer<vtkStructuredGrid> curvilinearGrid(
  const std::array<int, 3>& cells, const Movement& movement, const Field& field)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> ofPoints;
  ofPoints->SetName("f");
  vtkNew<vtkDoubleArray> ofCells;
  ofCells->SetName("c");
  for (int k = 0; k <= cells[2]; ++k)
  {
    for (int j = 0; j <= cells[1]; ++j)
    {
      for (int i = 0; i <= cells[0]; ++i)
      {
        const Vec3 p =
          movement({ double(i) / cells[0], double(j) / cells[1], double(k) / cells[2] });
        points->InsertNextPoint(p[0], p[1], p[2]);
        const double value = field(p[0], p[1], p[2]);
        ofPoints->InsertNextValue(value);
        if (i < cells[0] && j < cells[1] && k < cells[2])
        {
          ofCells->InsertNextValue(value);
        }
      }
    }
  }
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(cells[0] + 1, cells[1] + 1, cells[2] + 1);
  grid->SetPoints(points);
  grid->GetPointData()->SetScalars(ofPoints);
  grid->GetCellData()->AddArray(ofCells);
  return grid;
}

const std::vector<NamedMovement>& everyMovement()
{
  static const std::vector<NamedMovement> movements = {
    { "box", [](const Vec3& p) { return p; }, true },
    { "left-handed",
      [](const Vec3& p) {
        return Vec3{ 1 - p[0], p[1], p[2] };
      },
      true },
    { "bent",
      [](const Vec3& p) {
        return Vec3{ p[0] + 0.1 * std::sin(5 * p[1]), p[1] + 0.1 * p[2] * p[2], p[2] };
      },
      true },
    { "three quarters of a ring",
      [](const Vec3& p) { return turned(0.2 + 0.3 * p[0], 0.75 * p[1], p[2]); }, true },
    { "ring along i", [](const Vec3& p) { return turned(0.5 - 0.3 * p[1], p[0], p[2]); }, true,
      true },
    { "ring along j", [](const Vec3& p) { return turned(0.2 + 0.3 * p[0], p[1], p[2]); }, true,
      true },
    { "ring along k, left-handed",
      [](const Vec3& p) { return turned(0.2 + 0.3 * p[0], p[2], p[1]); }, true, true },
    { "cylinder with its axis", [](const Vec3& p) { return turned(0.5 * p[0], 0.9 * p[1], p[2]); },
      true, true },
    { "shell with poles", [](const Vec3& p) { return onSphere(0.2 + 0.3 * p[0], p[1], p[2]); },
      true, true },
    { "ball with its middle, along k",
      [](const Vec3& p) { return onSphere(0.5 - 0.5 * p[2], p[0], p[1]); }, true, true },
    { "hollow torus", [](const Vec3& p) { return onTorus(0.1 + 0.1 * p[0], p[1], p[2]); }, true,
      true },
    { "torus with its axis", [](const Vec3& p) { return onTorus(0.2 * p[1], p[2], p[0]); }, true,
      true },
    { "ring that closes in part",
      [](const Vec3& p)
      { return turned(0.2 + 0.3 * p[0], p[1] * (1 - std::max(0.0, 0.2 * p[2] - 0.1)), p[2]); },
      false },
    { "flat",
      [](const Vec3& p) {
        return Vec3{ p[0] + 0.3 * p[2], p[1], p[0] + 0.3 * p[2] };
      },
      false },
  };
  return movements;
}
} // namespace tetmarch::testing
