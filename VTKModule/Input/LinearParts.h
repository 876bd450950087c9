// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The linear cells between neighbouring points of a Lagrange or Bezier cell.
#ifndef TetMarchInputLinearParts_h
#define TetMarchInputLinearParts_h

#include <array>
#include <vector>

namespace tetmarch
{

/** Of a hexahedron along each axis; of a wedge along two sides of its triangles and its height. */
using CellDegrees = std::array<int, 3>;

bool isHigherOrderWedge(int cellType);
bool isHigherOrderHexahedron(int cellType);

struct LinearParts
{
  int Type;                             // VTK_HEXAHEDRON or VTK_WEDGE
  std::vector<std::vector<int>> Points; // of each part, by the cell's own numbers
};

/** Of a hexahedron or wedge with these degrees. Cells with a common face divide it alike. */
LinearParts linearParts(int cellType, const CellDegrees& degrees);

} // namespace tetmarch

#endif
