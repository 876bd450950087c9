// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WebPage/SurfaceTriangles.h"

#include "Geometry/Vector3.h"
#include "WebPage/SceneSurfaces.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <vector>

namespace tetmarch
{
namespace
{

// An array with values of points, of cells, or one value for all.
struct Attribute
{
  enum class Of
  {
    Points,
    Cells,
    All
  };
  vtkSmartPointer<vtkDataArray> Values;
  Of Owner = Of::Points;
  vtkIdType Tuple = 0; // of all

  bool isOfCells() const { return this->Values && this->Owner == Of::Cells; }

  vtkIdType tupleOf(vtkIdType point, vtkIdType cell) const
  {
    return this->Owner == Of::Points ? point : this->Owner == Of::Cells ? cell : this->Tuple;
  }
};

struct MappedScalars
{
  Attribute Colors;
  Attribute TableCoordinates; // in place of colours
  vtkSmartPointer<vtkImageData> Table;
};

// A copy maps the scalars: the mapper itself keeps what it has mapped.
MappedScalars mappedScalars(const OpaqueSurface& drawn)
{
  MappedScalars mapped;
  if (drawn.BlockColor)
  {
    return mapped;
  }
  vtkNew<vtkPolyDataMapper> copy;
  copy->vtkMapper::ShallowCopy(drawn.Mapper);
  int owner = 0;
  Attribute& colors = mapped.Colors;
  colors.Values = copy->MapScalars(drawn.Data, 1.0, owner);
  mapped.TableCoordinates.Values = copy->GetColorCoordinates();
  mapped.Table = copy->GetColorTextureMap();
  const bool one = owner == 2 && copy->GetFieldDataTupleId() >= 0;
  colors.Owner = one          ? Attribute::Of::All
                 : owner == 0 ? Attribute::Of::Points
                              : Attribute::Of::Cells;
  colors.Tuple = one ? copy->GetFieldDataTupleId() : 0;
  return mapped;
}

Attribute normalsOf(vtkPolyData* data, bool flat)
{
  if (flat)
  {
    return {};
  }
  if (vtkDataArray* ofPoints = data->GetPointData()->GetNormals())
  {
    return { ofPoints, Attribute::Of::Points };
  }
  return { data->GetCellData()->GetNormals(), Attribute::Of::Cells };
}

bool isFinite(const Vector3& p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

constexpr std::uint32_t Unused = 0xffffffff;

class Builder
{
public:
  Builder(const OpaqueSurface& drawn, Surface& surface)
    : Data(drawn.Data)
    , Filled(surface)
    , Scalars(mappedScalars(drawn))
    , Normals(normalsOf(drawn.Data, surface.Flat))
    , PerCell(Scalars.Colors.isOfCells() || Normals.isOfCells())
    , Numbers(static_cast<std::size_t>(drawn.Data->GetNumberOfPoints()), Unused)
  {
    double bounds[6];
    this->Data->GetBounds(bounds);
    for (int k = 0; k < 3; ++k)
    {
      const double middle = 0.5 * (bounds[2 * k] + bounds[2 * k + 1]);
      this->Origin[k] = std::isfinite(middle) ? middle : 0.0;
    }
    const Vector3& o = this->Origin;
    const double move[16] = { 1, 0, 0, o[0], 0, 1, 0, o[1], 0, 0, 1, o[2], 0, 0, 0, 1 };
    vtkMatrix4x4::Multiply4x4(drawn.ToWorld.data(), move, surface.Matrix.data());
  }

  void addPolygons()
  {
    this->forEachCell(this->Data->GetPolys(),
      [this](const vtkIdType* p, vtkIdType i) { this->addTriangle(p[0], p[i - 1], p[i]); });
  }

  void addStrips()
  {
    this->forEachCell(this->Data->GetStrips(),
      [this](const vtkIdType* p, vtkIdType i)
      {
        const vtkIdType odd = i % 2;
        this->addTriangle(p[i - 2], p[i - 1 + odd], p[i - odd]);
      });
  }

  void addTable()
  {
    vtkImageData* table = this->Scalars.Table;
    if (table && this->Scalars.TableCoordinates.Values)
    {
      vtkDataArray* colors = table->GetPointData()->GetScalars();
      const auto* bytes = static_cast<const std::uint8_t*>(colors->GetVoidPointer(0));
      this->Filled.Table.assign(bytes, bytes + colors->GetNumberOfValues());
      this->Filled.TableWidth = table->GetDimensions()[0];
    }
  }

  void skip(vtkCellArray* cells) { this->Cell += cells->GetNumberOfCells(); }

private:
  // add(points, i) for each cell and each of its corners i from the third one on.
  template <typename Add>
  void forEachCell(vtkCellArray* cells, const Add& add)
  {
    auto cell = vtk::TakeSmartPointer(cells->NewIterator());
    for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell(), ++this->Cell)
    {
      vtkIdType size = 0;
      const vtkIdType* points = nullptr;
      cell->GetCurrentCell(size, points);
      for (vtkIdType i = 2; i < size; ++i)
      {
        add(points, i);
      }
      for (vtkIdType i = 0; this->PerCell && i < size; ++i)
      {
        this->Numbers[points[i]] = Unused;
      }
    }
  }

  void addTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
  {
    if (isFinite(this->point(a)) && isFinite(this->point(b)) && isFinite(this->point(c)))
    {
      for (const vtkIdType point : { a, b, c })
      {
        this->Filled.Triangles.push_back(this->numberOf(point));
      }
    }
  }

  Vector3 point(vtkIdType i) const
  {
    Vector3 p;
    this->Data->GetPoint(i, p.data());
    return p;
  }

  std::uint32_t numberOf(vtkIdType point)
  {
    std::uint32_t& number = this->Numbers[point];
    if (number == Unused)
    {
      number = static_cast<std::uint32_t>(this->Filled.Positions.size() / 3);
      this->addPoint(point);
    }
    return number;
  }

  void addPoint(vtkIdType i)
  {
    for (const double x : this->point(i) - this->Origin)
    {
      this->Filled.Positions.push_back(static_cast<float>(x));
    }
    this->append(this->Normals, i, this->Filled.Normals);
    this->append(this->Scalars.Colors, i, this->Filled.Colors);
    this->append(this->Scalars.TableCoordinates, i, this->Filled.TableCoordinates);
  }

  template <typename T>
  void append(const Attribute& attribute, vtkIdType point, std::vector<T>& values) const
  {
    const vtkIdType tuple = attribute.tupleOf(point, this->Cell);
    const int components = attribute.Values ? attribute.Values->GetNumberOfComponents() : 0;
    for (int k = 0; k < components; ++k)
    {
      values.push_back(static_cast<T>(attribute.Values->GetComponent(tuple, k)));
    }
  }

  vtkPolyData* Data;
  Surface& Filled;
  MappedScalars Scalars;
  Attribute Normals;
  bool PerCell;
  Vector3 Origin{};
  vtkIdType Cell = 0;                 // its number in the cell data
  std::vector<std::uint32_t> Numbers; // of points in the arrays
};

} // namespace

void addTriangles(const OpaqueSurface& drawn, Surface& surface)
{
  Builder builder(drawn, surface);
  builder.skip(drawn.Data->GetVerts());
  builder.skip(drawn.Data->GetLines());
  builder.addPolygons();
  builder.addStrips();
  builder.addTable();
}

} // namespace tetmarch
