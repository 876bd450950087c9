// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/CellGridField.h"

#include "Parallel/ParallelFor.h"

#include "vtkCellAttribute.h"
#include "vtkDGCell.h"
#include "vtkDataArray.h"

namespace tetmarch
{
namespace
{

using namespace vtk::literals;

vtkCellAttribute::CellTypeInfo infoOf(vtkDGCell* type, vtkCellAttribute* attribute)
{
  return attribute->GetCellTypeInfo(type->GetClassName());
}

bool isThere(const vtkCellAttribute::CellTypeInfo& info) { return info.FunctionSpace.IsValid(); }

} // namespace

FieldKind fieldKind(vtkDGCell* type, vtkCellAttribute* attribute)
{
  const auto info = infoOf(type, attribute);
  if (!isThere(info) || info.FunctionSpace == "constant"_token)
  {
    return FieldKind::Constant;
  }
  return info.FunctionSpace == "HGRAD"_token ? FieldKind::Nodal : FieldKind::Other;
}

int polynomialOrder(vtkDGCell* type, vtkCellAttribute* attribute)
{
  const auto info = infoOf(type, attribute);
  // What VTK doesn't know is an error of read(), whatever order it claims to have.
  if (fieldKind(type, attribute) != FieldKind::Nodal ||
      !type->GetOperatorEntry("Basis"_token, info))
  {
    return 0;
  }
  if (info.Basis == "F"_token && info.Order == 2) // with functions that vanish on edges
  {
    return type->GetShape() == vtkDGCell::Tetrahedron ? 4
           : type->GetShape() == vtkDGCell::Wedge     ? 3
                                                      : 2;
  }
  return info.Order;
}

std::string CellGridField::read(vtkDGCell* type, vtkCellAttribute* attribute)
{
  const std::string name = "The field \"" + attribute->GetName().Data() + "\" of the cell grid ";
  auto info = infoOf(type, attribute);
  if (!isThere(info))
  {
    return {};
  }
  this->Basis = type->GetOperatorEntry("Basis"_token, info);
  if (!this->Basis)
  {
    return name + "has functions on " + type->GetClassName() +
           " that VTK doesn't know: " + info.FunctionSpace.Data() + ", " + info.Basis.Data() +
           ", order " + std::to_string(info.Order) + ".";
  }
  this->Cells = type->GetCellSpec().Connectivity->GetNumberOfTuples();
  this->Components = attribute->GetNumberOfComponents();
  this->Values = info.GetArrayForRoleAs<vtkDataArray>("values"_token);
  if (info.DOFSharing.IsValid())
  {
    auto* own = info.GetArrayForRoleAs<vtkDataArray>("connectivity"_token);
    this->Connectivity = own ? own : type->GetCellSpec().Connectivity;
  }
  return this->check(name);
}

std::string CellGridField::check(const std::string& name) const
{
  const int functions = this->Basis.NumberOfFunctions;
  if (!this->Values)
  {
    return name + "has no values.";
  }
  const vtkIdType tuples = this->Values->GetNumberOfTuples();
  const int components = (this->Connectivity ? 1 : functions) * this->Components;
  if (this->Values->GetNumberOfComponents() != components)
  {
    return name + "has values of " + std::to_string(this->Values->GetNumberOfComponents()) +
           " components, but its functions need " + std::to_string(components) + ".";
  }
  if (!this->Connectivity)
  {
    return tuples >= this->Cells ? std::string()
                                 : name + "has values for " + std::to_string(tuples) + " of " +
                                     std::to_string(this->Cells) + " cells.";
  }
  if (this->Connectivity->GetNumberOfComponents() < functions ||
      this->Connectivity->GetNumberOfTuples() < this->Cells)
  {
    return name + "has " + std::to_string(functions) +
           " functions in each cell, but its connectivity is shorter.";
  }
  for (vtkIdType cell = 0; cell < this->Cells; ++cell)
  {
    for (int function = 0; function < functions; ++function)
    {
      const double id = this->Connectivity->GetComponent(cell, function);
      if (!(id >= 0 && id < static_cast<double>(tuples)))
      {
        return name + "has " + std::to_string(tuples) + " values, but cell " +
               std::to_string(cell) + " names number " +
               std::to_string(static_cast<long long>(id)) + ".";
      }
    }
  }
  return {};
}

void CellGridField::evaluate(const std::vector<std::array<double, 3>>& places, double* values) const
{
  const auto functions = static_cast<std::size_t>(this->Basis.NumberOfFunctions);
  const auto components = static_cast<std::size_t>(this->Components);
  std::vector<std::vector<double>> weights(places.size(), std::vector<double>(functions));
  for (std::size_t place = 0; place < (this->Values ? places.size() : 0); ++place)
  {
    this->Basis.Op(places[place], weights[place]);
  }
  parallelFor(0, this->Cells,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<double> ofFunctions(functions * components);
      double* value = values + static_cast<std::size_t>(begin) * places.size() * components;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        for (std::size_t f = 0; this->Connectivity && f < functions; ++f)
        {
          this->Values->GetTuple(
            static_cast<vtkIdType>(this->Connectivity->GetComponent(cell, static_cast<int>(f))),
            ofFunctions.data() + f * components);
        }
        this->Connectivity ? void() : this->Values->GetTuple(cell, ofFunctions.data());
        for (const std::vector<double>& ofPlace : weights)
        {
          for (std::size_t c = 0; c < components; ++c, ++value)
          {
            *value = 0;
            for (std::size_t f = 0; f < functions; ++f)
            {
              *value += ofPlace[f] * ofFunctions[f * components + c];
            }
          }
        }
      }
    });
}

} // namespace tetmarch
