// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells between the centres of leaves.
#ifndef TetMarchLeavesDualCells_h
#define TetMarchLeavesDualCells_h

#include "Leaves/MixedPoints.h"

namespace tetmarch
{

/** Cells of points that MixedPoints numbers, in VTK's order. */
struct DualCells
{
  std::vector<MixedPoint> Mixed;
  std::vector<std::array<int, 8>> Boxes;
  std::vector<std::array<int, 5>> Pyramids;
  std::vector<std::array<int, 4>> Tetrahedra;
};

/**
 * The cells around each corner fill the leaves that are drawn, without gaps and overlaps, for any
 * differences of level: a box where the centres of eight leaves form one; else pyramids and
 * tetrahedra between the corner, points on the edges and in the faces that meet there, and centres,
 * as in a barycentric subdivision, which can't fold. (Without these points the dual cells of Weber
 * et al., Extraction of Crack-free Isosurfaces from Adaptive Mesh Refinement Data, 2001, fold where
 * levels differ by more than one.) Where levels of neighbours differ by at most one, a linear
 * function is reproduced. In the outer halves of leaves at the border values are constant across
 * it.
 */
DualCells dualCellsOf(const Leaves& leaves, const std::vector<LeafCorner>& corners);

} // namespace tetmarch

#endif
