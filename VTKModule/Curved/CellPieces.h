// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedra of one curved cell, while it is cut.
#ifndef TetMarchCurvedCellPieces_h
#define TetMarchCurvedCellPieces_h

#include "Curved/CurvedCell.h"
#include "Curved/CurvedShape.h"

#include <array>
#include <cstdint>
#include <vector>

namespace tetmarch
{

/** A point of the output, and the first one at its place: cells may have points of their own. */
struct PiecePoint
{
  std::uint32_t Id;
  std::uint32_t Place;
};
inline bool operator<(const PiecePoint& a, const PiecePoint& b)
{
  return a.Place != b.Place ? a.Place < b.Place : a.Id < b.Id;
}

struct PieceCorner
{
  PiecePoint Point;
  std::array<float, 3> At; // parametric coordinates: sums of powers of 1/2, so exact
  std::uint8_t Faces;      // of the cell in which it is, a bit for each

  Vector3 place() const { return { { this->At[0], this->At[1], this->At[2] } }; }
};
using Piece = std::array<PieceCorner, 4>;

constexpr int PieceEdges[6][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } };

/** The faces in which a corner is, a bit for each. */
std::uint8_t facesOf(const CurvedShape& shape, int corner);

/** Between the corners of a cell, which are these points. Each face is fanned from the corner of
 * the first place, the cell from that of all, so neighbours divide a common face alike. */
std::vector<Piece> firstPieces(const CurvedShape& shape, const std::vector<PiecePoint>& points);

/** The middle of an edge, which is that point of the output. */
PieceCorner middleOf(const PieceCorner& a, const PieceCorner& b, PiecePoint point);

/** The edge (of PieceEdges) that is longest in parametric coordinates, or one of these; all cells
 * choose the same one in a common face. */
int longestEdge(const Piece& piece, const CurvedShape& shape);

} // namespace tetmarch

#endif
