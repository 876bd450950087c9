// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LatticeImages.h"

#include "LatticeGrids.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <limits>

namespace tetmarch::testing
{
namespace
{
constexpr std::array<double, 9> Identity = { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 };

// About the axis (1, 2, 3), by 0.7.
std::array<double, 9> turn()
{
  const double s = std::sin(0.35) / std::sqrt(14.0);
  const double quaternion[4] = { std::cos(0.35), 1.0 * s, 2.0 * s, 3.0 * s };
  double matrix[3][3];
  vtkMath::QuaternionToMatrix3x3(quaternion, matrix);
  std::array<double, 9> rows;
  for (int i = 0; i < 9; ++i)
  {
    rows[i] = matrix[i / 3][i % 3];
  }
  return rows;
}

// Where a point stands between the first and the last one, by its number or its coordinate.
using Shares = std::array<std::vector<double>, 3>;

std::vector<double> between(const std::vector<double>& shares)
{
  std::vector<double> middles;
  for (std::size_t i = 1; i < shares.size(); ++i)
  {
    middles.push_back(0.5 * (shares[i - 1] + shares[i]));
  }
  return middles;
}

vtkSmartPointer<vtkDoubleArray> valuesOf(const Field& field, const Shares& at, const char* name)
{
  auto values = vtkSmartPointer<vtkDoubleArray>::New();
  values->SetName(name);
  for (const double z : at[2])
  {
    for (const double y : at[1])
    {
      for (const double x : at[0])
      {
        values->InsertNextValue(field(x, y, z));
      }
    }
  }
  return values;
}

void attach(vtkDataSet* data, const Field& field, const Shares& points)
{
  data->GetPointData()->SetScalars(valuesOf(field, points, "f"));
  const Shares middles = { between(points[0]), between(points[1]), between(points[2]) };
  data->GetCellData()->SetScalars(valuesOf(field, middles, "c"));
}

vtkSmartPointer<vtkDataArray> converted(vtkDataArray* from, int vtkType)
{
  const auto to = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(vtkType));
  to->SetName(from->GetName());
  to->SetNumberOfTuples(from->GetNumberOfTuples());
  const std::array<double, 2> range = rangeInType(vtkType);
  const bool isFloating = vtkType == VTK_FLOAT || vtkType == VTK_DOUBLE;
  for (vtkIdType i = 0; i < from->GetNumberOfTuples(); ++i)
  {
    const double value = range[0] + from->GetComponent(i, 0) * (range[1] - range[0]);
    to->SetComponent(i, 0, isFloating ? value : std::round(value));
  }
  return to;
}

void mark(vtkDataSetAttributes* attributes, vtkIdType count, int bits, const TupleFilter& which)
{
  auto ghosts = vtkSmartPointer<vtkUnsignedCharArray>(vtkUnsignedCharArray::SafeDownCast(
    attributes->GetArray(vtkDataSetAttributes::GhostArrayName())));
  if (!ghosts)
  {
    ghosts = vtkSmartPointer<vtkUnsignedCharArray>::New();
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->SetNumberOfValues(count);
    ghosts->FillValue(0);
    attributes->AddArray(ghosts);
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    ghosts->SetValue(i, static_cast<unsigned char>(ghosts->GetValue(i) | (which(i) ? bits : 0)));
  }
}

void spoil(vtkDataArray* scalars, const TupleFilter& which)
{
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    if (which(i))
    {
      scalars->SetComponent(i, 0, std::numeric_limits<double>::quiet_NaN());
    }
  }
}
} // namespace

ImagePlace unitCube(int n)
{
  return { "unit cube", { 0, n, 0, n, 0, n }, { 0.0, 0.0, 0.0 }, { 1.0 / n, 1.0 / n, 1.0 / n },
    Identity };
}

std::vector<ImagePlace> imagePlaces()
{
  const std::array<double, 9> mirrored = { 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0 };
  const std::array<double, 9> sheared = { 1.0, 0.3, 0.0, 0.0, 1.0, -0.4, 0.2, 0.0, 1.0 };
  return {
    { "plain", { 0, 6, 0, 5, 0, 4 }, { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, Identity },
    { "uneven spacing", { 0, 6, 0, 5, 0, 4 }, { 0.0, 0.0, 0.0 }, { 0.3, 1.0, 2.7 }, Identity },
    { "far origin", { 0, 6, 0, 5, 0, 4 }, { 148376.0, 1234.0, -223423.0 }, { 1.0, 1.0, 1.0 },
      Identity },
    { "negative spacing", { 0, 6, 0, 5, 0, 4 }, { 1.0, 2.0, 3.0 }, { -1.0, 0.5, -0.7 }, Identity },
    { "turned", { 0, 6, 0, 5, 0, 4 }, { -1.0, 2.0, 0.5 }, { 1.0, 0.8, 1.3 }, turn() },
    { "mirrored", { 0, 6, 0, 5, 0, 4 }, { 0.0, 0.0, 0.0 }, { 1.0, 0.8, 1.3 }, mirrored },
    { "sheared", { 0, 6, 0, 5, 0, 4 }, { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, sheared },
    { "extent elsewhere", { 7, 13, -3, 2, -40, -36 }, { 0.1, 0.2, 0.3 }, { 0.5, 0.5, 0.5 },
      Identity },
    { "one cell thick", { 0, 6, 0, 5, 2, 3 }, { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, Identity },
    { "one cell", { 0, 1, 0, 1, 0, 1 }, { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, Identity },
    { "everything", { -2, 4, 5, 10, 100, 104 }, { 10.0, -20.0, 30.0 }, { -0.9, 1.1, 0.6 }, turn() },
  };
}

AxisCoordinates unevenCube(int n, unsigned seed)
{
  AxisCoordinates coordinates;
  coordinates.Name = "uneven";
  std::mt19937 generator(seed);
  for (std::vector<double>& axis : coordinates.Axes)
  {
    axis = { 0.0 };
    for (int i = 0; i < n; ++i)
    {
      axis.push_back(axis.back() + std::pow(10.0, uniform(generator)));
    }
    const double length = axis.back();
    for (double& x : axis)
    {
      x /= length;
    }
  }
  return coordinates;
}

std::vector<AxisCoordinates> rectilinearAxes()
{
  std::vector<AxisCoordinates> all = { unevenCube(6) };
  AxisCoordinates growing{ "growing", {} };
  AxisCoordinates far{ "far from 0", unevenCube(5, 2).Axes };
  for (std::vector<double>& axis : growing.Axes)
  {
    for (int i = 0; i < 7; ++i)
    {
      axis.push_back(std::pow(2.0, i) - 10.0);
    }
  }
  for (std::vector<double>& axis : far.Axes)
  {
    for (double& x : axis)
    {
      x = 100000.0 + 3.0 * x;
    }
  }
  all.push_back(growing);
  all.push_back(far);
  all.push_back(
    { "one cell thick", { { { -1.0, 0.0, 0.5, 3.0 }, { 0.0, 0.1 }, { 1.0, 2.0, 4.0 } } } });
  all.push_back({ "one cell", { { { -1.0, 3.0 }, { 0.0, 0.1 }, { 1.0, 2.0 } } } });
  return all;
}

vtkSmartPointer<vtkImageData> imageOf(const Field& field, const ImagePlace& place)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(const_cast<int*>(place.Extent.data()));
  image->SetOrigin(place.Origin.data());
  image->SetSpacing(place.Spacing.data());
  image->SetDirectionMatrix(place.Direction.data());
  Shares shares;
  for (int a = 0; a < 3; ++a)
  {
    const int cells = place.Extent[2 * a + 1] - place.Extent[2 * a];
    for (int i = 0; i <= cells; ++i)
    {
      shares[a].push_back(static_cast<double>(i) / cells);
    }
  }
  attach(image, field, shares);
  return image;
}

vtkSmartPointer<vtkRectilinearGrid> rectilinearOf(const Field& field, const AxisCoordinates& axes)
{
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  vtkNew<vtkDoubleArray> coordinates[3];
  Shares shares;
  for (int a = 0; a < 3; ++a)
  {
    const std::vector<double>& points = axes.Axes[a];
    for (const double x : points)
    {
      coordinates[a]->InsertNextValue(x);
      shares[a].push_back((x - points.front()) / (points.back() - points.front()));
    }
  }
  grid->SetDimensions(static_cast<int>(shares[0].size()), static_cast<int>(shares[1].size()),
    static_cast<int>(shares[2].size()));
  grid->SetXCoordinates(coordinates[0]);
  grid->SetYCoordinates(coordinates[1]);
  grid->SetZCoordinates(coordinates[2]);
  attach(grid, field, shares);
  return grid;
}

std::vector<int> numberTypes()
{
  return { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_INT,
    VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG,
    VTK_ID_TYPE, VTK_FLOAT, VTK_DOUBLE };
}

std::array<double, 2> rangeInType(int vtkType)
{
  switch (vtkType)
  {
    case VTK_CHAR:
    case VTK_SIGNED_CHAR:
    case VTK_UNSIGNED_CHAR:
      return { 3.0, 119.0 };
    case VTK_SHORT:
    case VTK_UNSIGNED_SHORT:
      return { 700.0, 31000.0 };
    case VTK_FLOAT:
    case VTK_DOUBLE:
      return { 0.0, 1.0 };
    default:
      return { 70000.0, 1.7e9 };
  }
}

void convertScalars(vtkDataSet* data, int vtkType)
{
  data->GetPointData()->SetScalars(converted(data->GetPointData()->GetScalars(), vtkType));
  data->GetCellData()->SetScalars(converted(data->GetCellData()->GetScalars(), vtkType));
}

void markCells(vtkDataSet* data, int bits, const TupleFilter& which)
{
  mark(data->GetCellData(), data->GetNumberOfCells(), bits, which);
}

void markPoints(vtkDataSet* data, int bits, const TupleFilter& which)
{
  mark(data->GetPointData(), data->GetNumberOfPoints(), bits, which);
}

void spoilScalars(vtkDataSet* data, const TupleFilter& points, const TupleFilter& cells)
{
  spoil(data->GetPointData()->GetScalars(), points);
  spoil(data->GetCellData()->GetScalars(), cells);
}
} // namespace tetmarch::testing
