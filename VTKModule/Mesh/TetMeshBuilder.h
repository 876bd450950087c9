// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Builds the mesh of a grid.
#ifndef TetMarchMeshTetMeshBuilder_h
#define TetMarchMeshTetMeshBuilder_h

#include "Mesh/PieceOptions.h"
#include "Mesh/TetMesh.h"
#include "Parallel/Progress.h"

#include <string>

class vtkUnstructuredGrid;

namespace tetmarch
{

enum class BuildStatus
{
  Done,
  Stopped,
  Failed
};

/**
 * Decompose, renumber, link, find the boundary and, unless the mesh is convex, build its hierarchy.
 * Scalars are left 0. On failure `error` describes the problem and its remedy; the mesh is then
 * unspecified.
 */
BuildStatus buildTetMesh(vtkUnstructuredGrid* grid, const Progress& progress, TetMesh& mesh,
  std::string& error, const PieceOptions& piece = {});

/** Build the hierarchy also for a convex mesh: rays without entry lists need it. */
void ensureHierarchy(TetMesh& mesh);

} // namespace tetmarch

#endif
