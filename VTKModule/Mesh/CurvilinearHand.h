// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether the cells of a curvilinear grid can be computed from i, j and k.
#ifndef TetMarchMeshCurvilinearHand_h
#define TetMarchMeshCurvilinearHand_h

#include "Mesh/TetMesh.h"
#include "Parallel/Progress.h"

namespace tetmarch
{

/**
 * 1 or -1 if the axes of all hexahedra are right-handed or left-handed; 0 if some tetrahedron is
 * flat to within the rounding of positions, or of the other hand. unfinished: progress asked to
 * stop.
 */
int handOf(const TetMesh& mesh, const Progress& progress, bool& unfinished);

} // namespace tetmarch

#endif
