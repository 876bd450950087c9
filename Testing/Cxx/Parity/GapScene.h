// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Cells of a scene that aren't drawn: hidden ones, and scalars that are not finite
 */
#ifndef tetmarch_testing_GapScene_h
#define tetmarch_testing_GapScene_h

#include "Scene.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <functional>
#include <limits>

namespace tetmarch::testing
{
constexpr double NotFinite[] = { std::numeric_limits<double>::quiet_NaN(),
  std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() };

/// Makes every 23rd scalar not finite.
inline void breakSome(vtkDataArray* scalars)
{
  for (vtkIdType i = 5, n = 0; i < scalars->GetNumberOfTuples(); i += 23, ++n)
  {
    scalars->SetTuple1(i, NotFinite[n % 3]);
  }
  scalars->Modified();
}

/// Whether a cell is chosen, by the centre of its bounds.
using Place = std::function<bool(double x, double y, double z)>;

inline bool isAt(vtkUnstructuredGrid* grid, vtkIdType cell, const Place& place)
{
  double b[6];
  grid->GetCellBounds(cell, b);
  return place(0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), 0.5 * (b[4] + b[5]));
}

inline void hide(
  vtkUnstructuredGrid* grid, const Place& place, int type = vtkDataSetAttributes::HIDDENCELL)
{
  vtkUnsignedCharArray* ghosts = grid->AllocateCellGhostArray();
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    ghosts->SetValue(cell, static_cast<unsigned char>(isAt(grid, cell, place) ? type : 0));
  }
  ghosts->Modified();
}

/// Small regions here and there in the unit cube.
inline bool isCrumb(double x, double y, double z)
{
  return std::sin(17.0 * x) * std::sin(19.0 * y) * std::sin(23.0 * z) > 0.1;
}
} // namespace tetmarch::testing

#endif
