// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The type of each cell.
#ifndef TetMarchInputCellTypes_h
#define TetMarchInputCellTypes_h

#include "Input/GridVersions.h"

#include "vtkUnsignedCharArray.h"

namespace tetmarch
{

/** Reads a grid's cell types (VTK_TETRA and so on) from any type of array. */
class CellTypes
{
public:
  explicit CellTypes(vtkUnstructuredGrid* grid)
    : Array(cellTypesOf(grid))
  {
    auto* stored = vtkUnsignedCharArray::SafeDownCast(this->Array);
    this->Stored = stored ? stored->GetPointer(0) : nullptr;
  }

  /** One value per cell, of type unsigned char, if checkGrid() has found no error; null without
   * cell types. */
  vtkDataArray* array() const { return this->Array; }

  unsigned char operator[](vtkIdType cell) const
  {
    return this->Stored ? this->Stored[cell]
                        : static_cast<unsigned char>(this->Array->GetComponent(cell, 0));
  }

private:
  vtkDataArray* Array;
  const unsigned char* Stored; // null if the array computes its values
};

} // namespace tetmarch

#endif
