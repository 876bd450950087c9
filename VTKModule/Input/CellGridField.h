// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// One field of a vtkCellGrid (a vtkCellAttribute) on the cells of one type.
#ifndef TetMarchInputCellGridField_h
#define TetMarchInputCellGridField_h

#include "vtkDGOperatorEntry.h"
#include "vtkType.h"

#include <array>
#include <string>
#include <vector>

class vtkCellAttribute;
class vtkDGCell;
class vtkDataArray;

namespace tetmarch
{

enum class FieldKind // the more general, the greater
{
  Constant, // in each cell; or there is no such field
  Nodal,    // of the function space "HGRAD"
  Other
};

FieldKind fieldKind(vtkDGCell* type, vtkCellAttribute* attribute);

/** The order of a Lagrange cell whose functions include those of the field; 0 if it isn't nodal. */
int polynomialOrder(vtkDGCell* type, vtkCellAttribute* attribute);

class CellGridField
{
public:
  /** Returns an empty string, or an error if arrays are missing or too short. */
  std::string read(vtkDGCell* type, vtkCellAttribute* attribute);

  /** For each cell, each of these places (parametric coordinates of the type) and each component a
   * value. Leaves them as they are if there is no such field. */
  void evaluate(const std::vector<std::array<double, 3>>& places, double* values) const;

private:
  std::string check(const std::string& name) const;

  vtkDGOperatorEntry Basis;
  vtkIdType Cells = 0;
  int Components = 0;
  vtkDataArray* Values = nullptr;
  vtkDataArray* Connectivity = nullptr; // of values that cells share
};

} // namespace tetmarch

#endif
