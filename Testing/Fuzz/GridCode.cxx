// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GridCode.h"

#include "Mesh/CellKind.h"

#include "vtkBitArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetmarch::testing
{
namespace
{
constexpr int CellTypes[] = { VTK_TETRA, VTK_VOXEL, VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID,
  VTK_PENTAGONAL_PRISM, VTK_HEXAGONAL_PRISM, VTK_POLYHEDRON, VTK_CONVEX_POINT_SET,
  VTK_QUADRATIC_TETRA, VTK_QUADRATIC_HEXAHEDRON, VTK_QUADRATIC_WEDGE, VTK_QUADRATIC_PYRAMID,
  VTK_TRIQUADRATIC_HEXAHEDRON, VTK_TRIQUADRATIC_PYRAMID, VTK_QUADRATIC_LINEAR_WEDGE,
  VTK_BIQUADRATIC_QUADRATIC_WEDGE, VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, VTK_LAGRANGE_TETRAHEDRON,
  VTK_LAGRANGE_HEXAHEDRON, VTK_LAGRANGE_WEDGE, VTK_BEZIER_TETRAHEDRON, VTK_BEZIER_HEXAHEDRON,
  VTK_BEZIER_WEDGE };
constexpr int CountOfTypes = static_cast<int>(std::size(CellTypes));

constexpr double Scales[] = { 1.0, 1e-3, 1e3, 1e-30, 1e30, 1e-150, 1e98, 1e-300 };

const double WildNumbers[] = { std::nan(""), std::numeric_limits<double>::infinity(),
  -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::max(),
  std::numeric_limits<double>::lowest(), 1e300, 1e154, 1e101, 1e38, 1e-38, 1e-160,
  std::numeric_limits<double>::min(), std::numeric_limits<double>::denorm_min(), -0.0, 0.1,
  1.0 / 3.0 };

constexpr vtkIdType WildIds[] = { -1, -2, VTK_ID_MIN, VTK_ID_MAX, VTK_ID_MAX - 1, 0x7fffffff,
  0x80000000, 0xffffffff, 0x100000000, 0x3fffffffffffffff };

constexpr int ArrayTypes[] = { VTK_DOUBLE, VTK_FLOAT, VTK_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
  VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_ID_TYPE, VTK_UNSIGNED_LONG_LONG, VTK_BIT };

class Reader
{
public:
  explicit Reader(const Bytes& bytes)
    : Data(bytes)
  {
  }

  int byte() { return this->At < this->Data.size() ? this->Data[this->At++] : 0; }
  int signedByte() { return static_cast<std::int8_t>(this->byte()); }
  int word() { return this->byte() | this->byte() << 8; }
  double number()
  {
    const int value = this->signedByte();
    return value == -128 ? WildNumbers[this->byte() % std::size(WildNumbers)] : value;
  }
  vtkIdType id()
  {
    const int value = this->signedByte();
    return value == -128 ? WildIds[this->byte() % std::size(WildIds)] : value;
  }
  bool isAtEnd() const { return this->At >= this->Data.size(); }

private:
  const Bytes& Data;
  std::size_t At = 0;
};

void readPoints(Reader& reader, double scale, RawGrid& raw)
{
  const int count = reader.byte();
  for (int i = 0; i < 3 * count; ++i)
  {
    raw.Points.push_back(scale * reader.number());
  }
}

class CellReader
{
public:
  CellReader(Reader& reader, RawGrid& raw)
    : In(reader)
    , Raw(raw)
    , NumberOfPoints(std::max(static_cast<int>(raw.Points.size() / 3), 1))
  {
  }

  void read()
  {
    this->Raw.Offsets = { 0 };
    for (int cells = this->In.byte(); cells > 0 && !this->In.isAtEnd(); --cells)
    {
      const int code = this->In.byte();
      const int type = code < 128 ? CellTypes[code % CountOfTypes] : code - 128;
      this->Raw.Types.push_back(static_cast<unsigned char>(type));
      if (type == VTK_POLYHEDRON)
      {
        this->readPolyhedron();
      }
      else
      {
        this->Raw.Faces.addNone();
        this->readPoints(type);
      }
      this->Raw.Offsets.push_back(static_cast<vtkIdType>(this->Raw.Connectivity.size()));
    }
  }

private:
  vtkIdType point() { return this->In.byte() % this->NumberOfPoints; }

  void readPoints(int type)
  {
    const CellKind& kind = cellKinds()[type];
    const bool fixed = kind.LeastPoints == kind.MostPoints;
    const vtkIdType count = fixed ? kind.LeastPoints : this->In.byte() % 65;
    for (vtkIdType i = 0; i < count; ++i)
    {
      this->Raw.Connectivity.push_back(this->point());
    }
  }

  void readPolyhedron()
  {
    this->Raw.HasFaces = true;
    Ids all;
    std::vector<Ids> faces(this->In.byte() % 32);
    for (Ids& face : faces)
    {
      face.resize(this->In.byte() % 16);
      for (vtkIdType& point : face)
      {
        point = this->point();
        all.push_back(point);
      }
    }
    this->Raw.Faces.add(faces);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    this->Raw.Connectivity.insert(this->Raw.Connectivity.end(), all.begin(), all.end());
  }

  Reader& In;
  RawGrid& Raw;
  int NumberOfPoints;
};

template <typename T>
void damage(Reader& reader, std::vector<T>& values)
{
  const int how = reader.byte() % 3;
  const int where = reader.word();
  const vtkIdType value = reader.id();
  if (how == 0)
  {
    values.resize(std::min<std::size_t>(where, values.size()));
  }
  else if (how == 1)
  {
    values.push_back(static_cast<T>(value));
  }
  else if (!values.empty())
  {
    values[where % values.size()] = static_cast<T>(value);
  }
}

void damage(Reader& reader, const std::vector<Ids*>& arrays)
{
  damage(reader, *arrays[arrays.size() > 1 ? reader.byte() % arrays.size() : 0]);
}

void damage(Reader& reader, RawGrid& raw)
{
  for (int count = reader.byte() % 8; count > 0; --count)
  {
    switch (reader.byte() % 6)
    {
      case 0:
        damage(reader, raw.Offsets);
        break;
      case 1:
        damage(reader, raw.Connectivity);
        break;
      case 2:
        damage(reader, raw.Types);
        break;
      case 3:
        damage(reader, raw.Faces.locationArrays());
        break;
      case 4:
        damage(reader, raw.Faces.faceArrays());
        break;
      default:
        raw.HasFaces = !raw.HasFaces;
    }
  }
}

// A number as a value of an array that holds only some of them.
double valueFor(int type, double value)
{
  if (type == VTK_DOUBLE || type == VTK_FLOAT)
  {
    return value;
  }
  return std::isfinite(value) ? std::min(std::max(value, 0.0), 100.0) : 1.0;
}

vtkSmartPointer<vtkDataArray> readScalars(Reader& reader, vtkIdType expected)
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

vtkSmartPointer<vtkVolumeProperty> readFunctions(Reader& reader, bool inGray)
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

vtkSmartPointer<vtkDoubleArray> readArray(Reader& reader, int components, vtkIdType expected)
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

// A signed byte that is no escape.
std::uint8_t asByte(double value)
{
  return static_cast<std::uint8_t>(
    static_cast<std::int8_t>(std::lround(std::min(std::max(value, -127.0), 127.0))));
}

int codeOf(int type)
{
  const int* found = std::find(std::begin(CellTypes), std::end(CellTypes), type);
  return found == std::end(CellTypes) ? 128 + type : static_cast<int>(found - CellTypes);
}
} // namespace

FuzzInput decode(const Bytes& bytes)
{
  Reader reader(bytes);
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

Bytes encode(vtkUnstructuredGrid* grid, std::uint8_t flags, std::uint8_t seed)
{
  const RawGrid raw(grid);
  const double* bounds = grid->GetBounds();
  const double extent =
    std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  Bytes bytes{ flags, seed, 0, static_cast<std::uint8_t>(raw.Points.size() / 3) };
  for (std::size_t i = 0; i < raw.Points.size(); ++i)
  {
    bytes.push_back(asByte(250.0 * (raw.Points[i] - bounds[2 * (i % 3)]) / extent - 125.0));
  }
  bytes.push_back(static_cast<std::uint8_t>(raw.Types.size()));
  vtkNew<vtkIdList> ids;
  for (std::size_t cell = 0; cell < raw.Types.size(); ++cell)
  {
    const int type = raw.Types[cell];
    bytes.push_back(static_cast<std::uint8_t>(codeOf(type)));
    grid->GetFaceStream(static_cast<vtkIdType>(cell), ids); // or points, if it is no polyhedron
    if (type != VTK_POLYHEDRON && cellKinds()[type].LeastPoints != cellKinds()[type].MostPoints)
    {
      bytes.push_back(static_cast<std::uint8_t>(ids->GetNumberOfIds()));
    }
    bytes.insert(bytes.end(), ids->begin(), ids->end());
  }
  bytes.push_back(0);                     // no damage
  bytes.insert(bytes.end(), { 0, 0, 0 }); // doubles, one component, as many as expected
  const std::size_t scalars = (flags & 4) != 0 ? raw.Types.size() : raw.Points.size() / 3;
  for (std::size_t i = 0; i < scalars; ++i)
  {
    bytes.push_back(asByte(static_cast<double>(i * 37 % 201) - 100.0));
  }
  // One node between the two that are always there.
  bytes.insert(bytes.end(), { 1, 10, 255, 40, 0, 128, 0, 30, 128, 0 });
  return bytes;
}
} // namespace tetmarch::testing
