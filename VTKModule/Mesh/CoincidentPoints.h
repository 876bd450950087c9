// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Points of a grid that have equal coordinates.
#ifndef TetMarchMeshCoincidentPoints_h
#define TetMarchMeshCoincidentPoints_h

#include "Mesh/TetMesh.h"

class vtkUnstructuredGrid;

namespace tetmarch
{

/**
 * For each point of the grid the first one with equal coordinates, itself or one before it. Points
 * that no 3D cell has are NoPoint. Empty if no two points of 3D cells coincide.
 *
 * Coordinates are compared exactly, without a tolerance; -0 equals 0. inFloat: they are rounded to
 * float first. The grid has passed checkData().
 */
std::vector<Id> findCoincidentPoints(vtkUnstructuredGrid* grid, bool inFloat);

} // namespace tetmarch

#endif
