// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Where the outline of a volume is seen in a picture: the edges between a face that is turned to
// the eye and one that isn't. An outline that no ray touches is found by them.
#ifndef TetMarchEntriesOutlines_h
#define TetMarchEntriesOutlines_h

#include "Mesh/TetMesh.h"
#include "View/View.h"

#include <array>
#include <vector>

namespace tetmarch
{

/** An edge of the boundary, in the normalised frame, with the outward planes of its two faces: n
 * and -n . p. Both are 0 if it has not exactly two; then it always counts as outline. */
struct OutlineEdge
{
  std::array<Vector3, 2> Ends;
  std::array<std::array<double, 4>, 2> Planes;
};

std::vector<OutlineEdge> outlineEdgesOf(const TetMesh& mesh);
/** Of the box around the centre of the normalised frame. */
std::vector<OutlineEdge> outlineEdgesOf(const Vector3& halfExtent);

/** Cells of a picture, from a corner in pixels on. */
struct PictureCells
{
  std::array<int, 2> Picture; // its width and height, in pixels
  std::array<int, 2> Corner;
  int Side;                 // of a cell, in pixels
  std::array<int, 2> Count; // columns and rows of cells
};

/** 1 for each cell that an outline touches, 0 for others; rows from the bottom. */
std::vector<float> outlineCells(
  const std::vector<OutlineEdge>& edges, const View& view, const PictureCells& where);

} // namespace tetmarch

#endif
