// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The faces of VTK's cells, by local point numbers.
#ifndef TetMarchInputCellShapes_h
#define TetMarchInputCellShapes_h

#include <vector>

namespace tetmarch
{

using Polygon = std::vector<int>;

/** A part of a cell, bounded by polygons, that is cut into tetrahedra. A piece that is cut from one
 * of its points contains the mean of the cell's points, by which CellCutter determines the inner
 * side of a face. */
struct CellPiece
{
  std::vector<Polygon> Faces;
  int Apex; // local index of the point from which to cut, or one of:
};
constexpr int ApexSmallestId = -1; // the point with the smallest id in the piece
constexpr int ApexMean = -2;       // a new point, the mean of the cell's points

/**
 * The pieces of a cell type of fixed shape: voxel, hexahedron, wedge, pyramid, pentagonal and
 * hexagonal prism; quadratic tetrahedron, hexahedron, wedge, pyramid and triquadratic hexahedron,
 * whose faces are cut into linear ones through the points on their edges. nullptr for every other
 * type.
 */
const std::vector<CellPiece>* cellPieces(int cellType);

} // namespace tetmarch

#endif
