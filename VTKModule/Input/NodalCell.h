// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The cells of VTK that have the functions of cells of a vtkCellGrid.
#ifndef TetMarchInputNodalCell_h
#define TetMarchInputNodalCell_h

#include <array>
#include <vector>

class vtkDGCell;

namespace tetmarch
{

struct NodalCell
{
  using Node = std::array<double, 3>;
  int Type = 0;
  std::vector<Node> Nodes; // parametric coordinates of the cell grid's type
};

/** A linear cell for order 1, else the Lagrange cell of that order; of pyramids the one of order 2.
 */
NodalCell nodalCell(vtkDGCell* type, int order);

} // namespace tetmarch

#endif
