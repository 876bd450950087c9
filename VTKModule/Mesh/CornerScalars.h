// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Scalars of points with equal coordinates, which share a vertex of the mesh.
#ifndef TetMarchMeshCornerScalars_h
#define TetMarchMeshCornerScalars_h

#include "Mesh/TetMesh.h"

class vtkDataArray;
class vtkPointSet;

namespace tetmarch
{

/** The points of 3D cells, by TetMesh::FirstPoints; none if no two coincide. */
std::vector<Id> pointsOfSolids(const TetMesh& mesh);

/** Whether scalars of points that coincide differ by more than their rounding. `ofPoints`: one for
 * each point. */
bool scalarsJump(const TetMesh& mesh, const std::vector<float>& ofPoints, float rounding);

/** Maximum difference of two stored scalars that may be one value, rounded twice: programs of
 * finite elements compute the value of a continuous field anew in each cell. */
float roundingOf(vtkDataArray* array, const ScalarRange& range);

/** The scalars of the corners of each tetrahedron: those of the points of its own cell. Vertices in
 * centres of cells have theirs in the mesh. If a cell has several points in one place, that of the
 * first is taken. */
std::vector<std::array<float, 4>> cornerScalars(
  vtkPointSet* grid, const TetMesh& mesh, const std::vector<float>& ofPoints);

} // namespace tetmarch

#endif
