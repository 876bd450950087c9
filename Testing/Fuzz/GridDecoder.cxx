// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ByteReader.h"
#include "CellReader.h"
#include "GridCode.h"
#include "GridDamage.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace tetmarch::testing
{
namespace
{
constexpr double Scales[] = { 1.0, 1e-3, 1e3, 1e-30, 1e30, 1e-150, 1e98, 1e-300 };

constexpr int ArrayTypes[] = { VTK_DOUBLE, VTK_FLOAT, VTK_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
  VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_ID_TYPE, VTK_UNSIGNED_LONG_LONG, VTK_BIT };

void readPoints(ByteReader& reader, double scale, RawGrid& raw)
{
  const int count = reader.byte();
  for (int i = 0; i < 3 * count; ++i)
  {
    raw.Points.push_back(scale * reader.number());
  }
}

// The number, changed to one that an array of this type can hold.
double valueFor(int type, double value)
{
  if (type == VTK_DOUBLE || type == VTK_FLOAT)
  {
    return value;
  }
  return std::isfinite(value) ? std::min(std::max(value, 0.0), 100.0) : 1.0;
}

vtkSmartPointer<vtkDataArray> readScalars(ByteReader& reader, vtkIdType expected)
{
  const int type = ArrayTypes[reader.byte() % std::size(ArrayTypes)];
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetName("f");
  array->SetNumberOfComponents(1 + reader.byte() % 3);
  array->SetNumberOfTuples(std::max<vtkIdType>(expected + reader.signedByte(), 0));
  array->Fill(0.0);
  for (vtkIdType i = 0; i < array->GetNumberOfTuples() && !reader.isAtEnd(); ++i)
  {
    array->SetComponent(i, 0, valueFor(type, reader.number()));
  }
  return array;
}

vtkSmartPointer<vtkVolumeProperty> readFunctions(ByteReader& reader, bool inGray)
{
  vtkNew<vtkColorTransferFunction> color;
  vtkNew<vtkPiecewiseFunction> gray;
  vtkNew<vtkPiecewiseFunction> opacity;
  color->AddRGBPoint(-100.0, 1.0, 0.2, 0.0);
  color->AddRGBPoint(100.0, 0.0, 0.5, 1.0);
  opacity->AddPoint(-100.0, 0.1);
  opacity->AddPoint(100.0, 0.9);
  for (int nodes = reader.byte() % 8; nodes > 0; --nodes)
  {
    const double x = reader.number();
    if (std::isfinite(x))
    {
      double shares[8];
      for (double& share : shares)
      {
        share = reader.byte() / 255.0;
      }
      color->AddRGBPoint(x, shares[0], shares[1], shares[2], shares[3], shares[4]);
      gray->AddPoint(x, shares[0], shares[3], shares[4]);
      opacity->AddPoint(x, shares[5], shares[6], shares[7]);
    }
  }
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  if (inGray)
  {
    property->SetColor(gray);
  }
  else
  {
    property->SetColor(color);
  }
  property->SetScalarOpacity(opacity);
  return property;
}

vtkSmartPointer<vtkDoubleArray> readArray(ByteReader& reader, int components, vtkIdType expected)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName("attribute");
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(std::max<vtkIdType>(expected + reader.signedByte(), 0));
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    array->SetValue(i, reader.isAtEnd() ? 1.0 : reader.number());
  }
  return array;
}
} // namespace

FuzzInput decode(const Bytes& bytes)
{
  ByteReader reader(bytes);
  const int flags = reader.byte();
  FuzzInput input;
  input.Seed = static_cast<unsigned>(reader.byte());
  RawGrid raw;
  raw.Wide = (flags & 1) == 0;
  raw.FloatPoints = (flags & 2) != 0;
  input.OfCells = (flags & 4) != 0;
  input.Law = (flags & 64) != 0 ? OpacityLaw::Structured : OpacityLaw::Unstructured;
  readPoints(reader, Scales[reader.byte() % std::size(Scales)], raw);
  CellReader(reader, raw).read();
  damage(reader, raw);
  input.Cells = raw.grid();
  const auto points = static_cast<vtkIdType>(raw.Points.size() / 3);
  const auto cells = static_cast<vtkIdType>(raw.Types.size());
  input.Scalars = readScalars(reader, input.OfCells ? cells : points);
  input.Property = readFunctions(reader, (flags & 8) != 0);
  if ((flags & 16) != 0)
  {
    input.Cells->GetCellData()->SetHigherOrderDegrees(readArray(reader, 3, cells));
  }
  if ((flags & 32) != 0)
  {
    input.Cells->GetPointData()->SetRationalWeights(readArray(reader, 1, points));
  }
  return input;
}
} // namespace tetmarch::testing
