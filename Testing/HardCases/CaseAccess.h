// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Cases by name, for tests (an unknown name throws), and their cells
 */
#ifndef tetmarch_testing_CaseAccess_h
#define tetmarch_testing_CaseAccess_h

#include "HardCase.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <stdexcept>
#include <string_view>

namespace tetmarch::testing
{
// What refers to the case refers to nothing of the name, as compilers would suspect of a reference.
inline const HardCase& caseOf(std::string_view name)
{
  const HardCase* hard = findHardCase(std::string(name));
  if (!hard)
  {
    throw std::invalid_argument("there is no hard case " + std::string(name));
  }
  return *hard;
}

inline Grid gridOf(std::string_view name) { return caseOf(name).Make(); }

/// The points of a cell.
inline Ids cellOf(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  grid->GetCells()->GetCellAtId(cell, ids);
  return { ids->begin(), ids->end() };
}
} // namespace tetmarch::testing

#endif
