// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether points with equal coordinates have different scalars.
#ifndef TetMarchMeshScalarJumps_h
#define TetMarchMeshScalarJumps_h

#include "Mesh/TetMesh.h"
#include "Scalars/DrawnScalars.h"

namespace tetmarch
{

/** The points of 3D cells, by TetMesh::FirstPoints; none if no two coincide. */
std::vector<Id> pointsOfSolids(const TetMesh& mesh);

/** Whether points that coincide have different drawn scalars, as they are stored: rounded to float
 * in 0..1. Never for scalars of cells. */
bool scalarsJump(const DrawnScalars& drawn, const TetMesh& mesh);

} // namespace tetmarch

#endif
