// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Cuts the 3D cells of an unstructured grid into tetrahedra.
#ifndef TetMarchMeshDecomposition_h
#define TetMarchMeshDecomposition_h

#include "Mesh/PieceOptions.h"
#include "Mesh/TetMesh.h"
#include "Parallel/Progress.h"

#include <string>

class vtkUnstructuredGrid;

namespace tetmarch
{

/** Tetrahedra over points of the grid; ids from the number of points on are centres of cells. */
struct Decomposition
{
  std::vector<std::array<Id, 4>> Tets; // points in the order of the cell, any orientation
  std::vector<Id> Cells;               // one per tetrahedron
  std::vector<Id> CenterCells;
  std::vector<std::array<double, 3>> CenterPositions; // the mean of the cell's points
  bool HasCutCells = false;    // some tetrahedra come from cells of other types
  std::vector<Id> FirstPoints; // as in TetMesh
  MeshReport Report;
};

/**
 * Cut every 3D cell into tetrahedra, conformingly: points with equal coordinates are one point, the
 * first of them, unless the options keep them separate. A face with more than three corners is cut
 * through its corner with the smallest point id, in the cells on both sides. The interior of a cell
 * is cut from its own smallest point (pulling; Dompierre et al., "How to subdivide pyramids, prisms
 * and hexahedra into tetrahedra", 1999). If that point doesn't see all faces (non-convex or
 * strongly warped cells), it is cut from the mean of the cell's points, which becomes a vertex with
 * the mean scalar. Points of pieces are ordered by their coordinates in place of their ids.
 *
 * Returns an empty string, or the error of the grid (GridCheck.h). `stopped` becomes true if
 * progress requested a stop.
 */
std::string decompose(vtkUnstructuredGrid* grid, const Progress& progress, Decomposition& result,
  bool& stopped, const PieceOptions& piece = {});

} // namespace tetmarch

#endif
