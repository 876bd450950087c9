// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Tetrahedra whose faces don't meet one to one, or close to no orientable whole
 */
#ifndef tetmarch_testing_NonManifoldGrids_h
#define tetmarch_testing_NonManifoldGrids_h

#include "GridBuilder.h"

namespace tetmarch::testing
{
/// Three tetrahedra on the face (0,0,0) (1,0,0) (0,1,0): two above it, of which one holds the tip
/// of the other, and one below.
Grid faceOfThreeTets(const Field& field = linearField());

/// A plain lattice of n^3 cubes in the unit cube, then a third tetrahedron on the face between the
/// first two tetrahedra of every cube, its tip outside both at most half a cube away.
Grid latticeWithThirdOwners(int n, const Field& field = linearField());

/// The unit cube, cut into cubes of edge 1/n for x <= 1/2 and of edge 1/(2n) beyond (n even): the
/// faces in the middle don't match. The points there that only the fine cubes have move by `bulge`
/// of a fine edge along x, alternately to both sides, which opens gaps and makes overlaps.
Grid hangingNodes(int n, double bulge = 0.0, const Field& field = linearField());

/// The unit cube, cut into cubes of edge 1/n. About one in `oneIn` of these is cut into eight.
Grid refinedCubes(int n, unsigned oneIn, unsigned seed, const Field& field = linearField());

/// A strip of width 1 and thickness 0.1 on a circle of radius 1 that turns over once, like that of
/// Moebius, with a triangle (left edge, right edge, ridge) as its cross-section: segments times
/// three tetrahedra, each a neighbour of the next. The last segment joins the left edge to the
/// right edge of the first, the right to the left, and ridge to ridge, so that no orientation of
/// the tetrahedra fits all their common faces. In space half a turn brings the edges there anyway
/// but the ridge to the other side of the strip: in the last segment it passes through the strip,
/// whose tetrahedra overlap there and turn over.
Grid moebiusRing(int segments, const Field& field = linearField());
} // namespace tetmarch::testing

#endif
