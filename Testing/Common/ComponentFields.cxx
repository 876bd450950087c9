// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ComponentFields.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <cmath>

namespace tetmarch::testing
{
namespace
{
vtkSmartPointer<vtkDataArray> makeArray(
  const std::vector<Field>& fields, int type, const std::vector<Vec3>& places)
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  const bool real = type == VTK_FLOAT || type == VTK_DOUBLE;
  array->SetName("components");
  array->SetNumberOfComponents(static_cast<int>(fields.size()));
  array->SetNumberOfTuples(static_cast<vtkIdType>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    for (std::size_t k = 0; k < fields.size(); ++k)
    {
      const double value = fields[k](places[i][0], places[i][1], places[i][2]);
      array->SetComponent(static_cast<vtkIdType>(i), static_cast<int>(k),
        real ? value : std::floor(255.0 * value + 0.5));
    }
  }
  return array;
}

Vec3 centreOf(vtkDataSet* grid, vtkIdType cell)
{
  vtkNew<vtkIdList> points;
  grid->GetCellPoints(cell, points);
  Vec3 centre{};
  for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
  {
    const double* p = grid->GetPoint(points->GetId(i));
    for (int k = 0; k < 3; ++k)
    {
      centre[k] += p[k] / static_cast<double>(points->GetNumberOfIds());
    }
  }
  return centre;
}
} // namespace

std::vector<Field> componentFields(int count)
{
  const std::vector<Field> fields{ [](double x, double y, double z)
    { return 0.2 * x + 0.3 * y + 0.5 * z; },
    [](double x, double y, double z) { return 0.9 - 0.6 * x + 0.1 * y - 0.2 * z; },
    [](double x, double y, double) { return 0.5 + 0.4 * x - 0.45 * y; },
    [](double x, double y, double z) { return 0.1 + 0.25 * x + 0.35 * y + 0.25 * z; } };
  return { fields.begin(), fields.begin() + count };
}

void setComponents(vtkDataSet* data, const std::vector<Field>& fields, int type)
{
  std::vector<Vec3> points, centres;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const double* p = data->GetPoint(i);
    points.push_back({ p[0], p[1], p[2] });
  }
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    centres.push_back(centreOf(data, i));
  }
  data->GetPointData()->SetScalars(makeArray(fields, type, points));
  data->GetCellData()->SetScalars(makeArray(fields, type, centres));
}

Grid withComponents(const Grid& grid, const std::vector<Field>& fields, int type)
{
  setComponents(grid, fields, type);
  return grid;
}

void setComponentFunctions(vtkVolumeProperty* property, int components)
{
  const double colors[4][3][3] = { { { 0.1, 0.2, 1.0 }, { 0.2, 1.0, 0.1 }, { 1.0, 0.3, 0.0 } },
    { { 1.0, 0.0, 0.5 }, { 0.9, 0.9, 0.2 }, { 0.0, 0.2, 0.3 } },
    { { 0.0, 1.0, 1.0 }, { 1.0, 1.0, 1.0 }, { 0.3, 0.0, 0.6 } },
    { { 0.6, 0.3, 0.1 }, { 0.0, 0.7, 0.2 }, { 0.2, 0.2, 0.9 } } };
  const double opacities[4][5] = { { 0.1, 0.8, 0.3, 0.0, 0.6 }, { 0.0, 0.2, 0.9, 0.2, 0.0 },
    { 0.7, 0.0, 0.0, 0.4, 1.0 }, { 0.3, 0.5, 0.1, 0.7, 0.2 } };
  for (int k = 0; k < components; ++k)
  {
    vtkNew<vtkColorTransferFunction> color;
    vtkNew<vtkPiecewiseFunction> opacity;
    for (int i = 0; i < 3; ++i)
    {
      color->AddRGBPoint(
        0.5 * i + 0.05 * k * (i == 1 ? 1 : 0), colors[k][i][0], colors[k][i][1], colors[k][i][2]);
    }
    for (int i = 0; i < 5; ++i)
    {
      opacity->AddPoint(0.25 * i, opacities[k][i]);
    }
    property->SetColor(k, color);
    property->SetScalarOpacity(k, opacity);
    property->SetScalarOpacityUnitDistance(k, 0.25 * (1 + 0.5 * k));
    property->SetComponentWeight(k, 1.0 - 0.2 * k);
  }
}

std::array<double, 4> mediumAt(vtkVolumeProperty* property, const std::vector<double>& scalars,
  const std::function<double(double)>& extinctionOf)
{
  const int count = static_cast<int>(scalars.size());
  std::array<double, 4> medium{};
  const auto add = [&medium](const double* rgb, double extinction)
  {
    for (int k = 0; k < 3; ++k)
    {
      medium[k] += rgb[k] * extinction;
    }
    medium[3] += extinction;
  };
  double rgb[3];
  if (property->GetIndependentComponents())
  {
    for (int k = 0; k < count; ++k)
    {
      property->GetRGBTransferFunction(k)->GetColor(scalars[k], rgb);
      add(rgb, property->GetComponentWeight(k) *
                 extinctionOf(property->GetScalarOpacity(k)->GetValue(scalars[k])) *
                 property->GetScalarOpacityUnitDistance(0) /
                 property->GetScalarOpacityUnitDistance(k));
    }
  }
  else if (count == 2)
  {
    property->GetRGBTransferFunction()->GetColor(scalars[0], rgb);
    add(rgb, extinctionOf(property->GetScalarOpacity()->GetValue(scalars[1])));
  }
  else
  {
    add(scalars.data(), extinctionOf(property->GetScalarOpacity()->GetValue(scalars[3])));
  }
  return medium;
}
} // namespace tetmarch::testing
