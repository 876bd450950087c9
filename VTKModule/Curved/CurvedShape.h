// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The corners and faces of quadratic, Lagrange and Bezier cells.
#ifndef TetMarchCurvedCurvedShape_h
#define TetMarchCurvedCurvedShape_h

#include "Geometry/Vector3.h"

#include <vector>

namespace tetmarch
{

enum class CurvedKind
{
  Tetrahedron,
  Hexahedron,
  Wedge,
  Pyramid
};

/** The linear cell with the same corners, which are the first points of a curved one. */
struct CurvedShape
{
  CurvedKind Kind;
  std::vector<Vector3> Corners;        // parametric coordinates, affine along edges and in faces
  std::vector<std::vector<int>> Faces; // corners in turn
};

/** nullptr for linear cells, for those of less than three dimensions, and for those without shape
 * functions in VTK. */
const CurvedShape* curvedShape(int cellType);

/** The number of points of a cell that checkGrid() doesn't know, or 0. */
int pointsOfCurvedCell(int cellType);

} // namespace tetmarch

#endif
