// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/CellGridCells.h"

#include "Input/CellGridField.h"
#include "Input/NodalCell.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellGrid.h"
#include "vtkDGCell.h"
#include "vtkDoubleArray.h"
#include "vtkFiltersCellGrid.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticPointLocator.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace tetmarch
{
namespace
{

using namespace vtk::literals;

// In parts of the greatest coordinate: points that differ by rounding are as near.
constexpr double Rounding = 1e-13;

// The cells of a type, and where they and their points begin.
struct CellsOfType
{
  vtkDGCell* Type;
  NodalCell Cell;
  vtkIdType FirstCell;
  vtkIdType FirstPoint;
  vtkIdType count() const { return this->Type->GetCellSpec().Connectivity->GetNumberOfTuples(); }
  vtkIdType nodes() const { return static_cast<vtkIdType>(this->Cell.Nodes.size()); }
};

class Conversion
{
public:
  explicit Conversion(vtkCellGrid* grid)
    : Grid(grid)
    , Shape(grid->GetShapeAttribute())
  {
    for (const auto& attribute : grid->GetCellAttributeList())
    {
      if (attribute != this->Shape)
      {
        this->Attributes.push_back(attribute);
      }
    }
    std::sort(this->Attributes.begin(), this->Attributes.end(),
      [](const auto& a, const auto& b) { return a->GetId() < b->GetId(); });
  }

  std::string findTypes()
  {
    std::vector<std::string> names = this->Grid->GetCellTypes();
    std::sort(names.begin(), names.end());
    for (const std::string& name : names)
    {
      auto* type = vtkDGCell::SafeDownCast(this->Grid->GetCellType(name));
      if (!type || type->GetDimension() != 3 || type->GetCellSpec().Blanked ||
          !type->GetCellSpec().Connectivity || type->GetNumberOfCells() == 0)
      {
        continue;
      }
      const int order = this->orderOf(type);
      if (order > 2 && type->GetShape() == vtkDGCell::Pyramid)
      {
        return "The cell grid has pyramids of order " + std::to_string(order) +
               ", but VTK has functions for order 2 at most.";
      }
      const CellsOfType* last = this->Types.empty() ? nullptr : &this->Types.back();
      this->Types.push_back(
        { type, nodalCell(type, order), last ? last->FirstCell + last->count() : 0,
          last ? last->FirstPoint + last->count() * last->nodes() : 0 });
      this->IsCurved = this->IsCurved || order > 1;
    }
    return {};
  }

  std::string write(vtkUnstructuredGrid* cells)
  {
    this->writeCells(cells);
    vtkNew<vtkDoubleArray> positions;
    std::string error = this->evaluate(this->Shape, false, positions);
    if (!error.empty())
    {
      return error;
    }
    this->IsCurved ? this->joinRounded(positions) : void();
    vtkNew<vtkPoints> points;
    points->SetData(positions);
    cells->SetPoints(points);
    for (vtkCellAttribute* attribute : this->Attributes)
    {
      const FieldKind kind = this->kindOf(attribute);
      if (kind == FieldKind::Other)
      {
        continue;
      }
      const bool isConstant = kind == FieldKind::Constant;
      vtkNew<vtkDoubleArray> values;
      values->SetName(attribute->GetName().Data().c_str());
      error = this->evaluate(attribute, isConstant, values);
      if (!error.empty())
      {
        return error;
      }
      vtkDataSetAttributes* arrays =
        cells->GetAttributes(isConstant ? vtkDataObject::CELL : vtkDataObject::POINT);
      arrays->AddArray(values);
      if (!cells->GetPointData()->GetScalars() && !cells->GetCellData()->GetScalars())
      {
        arrays->SetActiveScalars(values->GetName());
      }
    }
    return {};
  }

private:
  int orderOf(vtkDGCell* type) const
  {
    int order = std::max(1, polynomialOrder(type, this->Shape));
    for (vtkCellAttribute* attribute : this->Attributes)
    {
      order = std::max(order, polynomialOrder(type, attribute));
    }
    return order;
  }

  // The most general of all types.
  FieldKind kindOf(vtkCellAttribute* attribute) const
  {
    FieldKind kind = FieldKind::Constant;
    for (const CellsOfType& cells : this->Types)
    {
      kind = std::max(kind, fieldKind(cells.Type, attribute));
    }
    return kind;
  }

  void writeCells(vtkUnstructuredGrid* cells) const
  {
    vtkNew<vtkUnsignedCharArray> types;
    vtkNew<vtkIdTypeArray> offsets;
    vtkIdType points = 0;
    offsets->InsertNextValue(0);
    for (const CellsOfType& ofType : this->Types)
    {
      for (vtkIdType cell = 0; cell < ofType.count(); ++cell)
      {
        types->InsertNextValue(static_cast<unsigned char>(ofType.Cell.Type));
        points += ofType.nodes();
        offsets->InsertNextValue(points);
      }
    }
    vtkNew<vtkIdTypeArray> connectivity;
    connectivity->SetNumberOfValues(points);
    std::iota(connectivity->GetPointer(0), connectivity->GetPointer(0) + points, vtkIdType(0));
    vtkNew<vtkCellArray> array;
    array->SetData(offsets, connectivity);
    cells->SetCells(types, array);
  }

  // At the nodes of all cells, or, of a constant field, in each of them. NaN where there is none.
  std::string evaluate(vtkCellAttribute* attribute, bool inCells, vtkDoubleArray* values) const
  {
    const vtkIdType components = attribute->GetNumberOfComponents();
    const CellsOfType* last = this->Types.empty() ? nullptr : &this->Types.back();
    values->SetNumberOfComponents(static_cast<int>(components));
    values->SetNumberOfTuples(!last     ? 0
                              : inCells ? last->FirstCell + last->count()
                                        : last->FirstPoint + last->count() * last->nodes());
    values->Fill(std::numeric_limits<double>::quiet_NaN());
    for (const CellsOfType& cells : this->Types)
    {
      CellGridField field;
      const std::string error = field.read(cells.Type, attribute);
      if (!error.empty())
      {
        return error;
      }
      const std::vector<NodalCell::Node> first(
        cells.Cell.Nodes.begin(), cells.Cell.Nodes.begin() + 1);
      field.evaluate(inCells ? first : cells.Cell.Nodes,
        values->GetPointer(components * (inCells ? cells.FirstCell : cells.FirstPoint)));
    }
    return {};
  }

  // Cells evaluate a node that they share in another order, so that it may differ by rounding.
  static void joinRounded(vtkDoubleArray* positions)
  {
    vtkNew<vtkPolyData> data;
    vtkNew<vtkPoints> points;
    points->SetData(positions);
    data->SetPoints(points);
    vtkBoundingBox box(points->GetBounds());
    double greatest = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      greatest = std::max(
        { greatest, std::abs(box.GetBound(2 * axis)), std::abs(box.GetBound(2 * axis + 1)) });
    }
    vtkNew<vtkStaticPointLocator> locator;
    locator->SetDataSet(data);
    locator->BuildLocator();
    std::vector<vtkIdType> joined(static_cast<std::size_t>(points->GetNumberOfPoints()));
    locator->MergePoints(Rounding * greatest, joined.data());
    for (std::size_t point = 0; point < joined.size(); ++point)
    {
      positions->SetTuple(static_cast<vtkIdType>(point), joined[point], positions);
    }
  }

  vtkCellGrid* Grid;
  vtkCellAttribute* Shape;
  std::vector<vtkSmartPointer<vtkCellAttribute>> Attributes; // others, in their order
  std::vector<CellsOfType> Types;
  bool IsCurved = false;
};

} // namespace

Fingerprint versionOfCellGrid(vtkDataObject* data)
{
  auto* grid = vtkCellGrid::SafeDownCast(data);
  Fingerprint version;
  add(version, grid);
  for (const std::string& name : grid->GetCellTypes())
  {
    auto* type = vtkDGCell::SafeDownCast(grid->GetCellType(name));
    add(version, type ? type->GetCellSpec().Connectivity : nullptr);
    for (const auto& attribute : grid->GetCellAttributeList())
    {
      const auto info = attribute->GetCellTypeInfo(name);
      add(version, attribute);
      add(version, info.GetArrayForRoleAs<vtkDataArray>("values"_token));
      add(version, info.GetArrayForRoleAs<vtkDataArray>("connectivity"_token));
    }
  }
  return version;
}

std::string makeCellsOfCellGrid(vtkDataObject* data, vtkSmartPointer<vtkUnstructuredGrid>& cells)
{
  auto* grid = vtkCellGrid::SafeDownCast(data);
  if (!grid->GetShapeAttribute())
  {
    return "The cell grid has no shape: call vtkCellGrid::SetShapeAttribute().";
  }
  vtkFiltersCellGrid::RegisterCellsAndResponders();
  cells = vtkSmartPointer<vtkUnstructuredGrid>::New();
  Conversion conversion(grid);
  std::string error = conversion.findTypes();
  return error.empty() ? conversion.write(cells) : error;
}

} // namespace tetmarch
