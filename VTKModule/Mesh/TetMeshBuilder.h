// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Makes the mesh that is marched from a grid.
#ifndef TetMarchMeshTetMeshBuilder_h
#define TetMarchMeshTetMeshBuilder_h

#include "Mesh/PieceOptions.h"
#include "Mesh/Progress.h"
#include "Mesh/TetMesh.h"

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
 * Scalars are left 0. On failure `error` says what is wrong and what to do; the mesh is then
 * unspecified.
 */
BuildStatus buildTetMesh(vtkUnstructuredGrid* grid, const Progress& progress, TetMesh& mesh,
  std::string& error, const PieceOptions& piece = {});

/** Build the hierarchy of a convex mesh too: rays that have no list of entries need it. */
void ensureHierarchy(TetMesh& mesh);

} // namespace tetmarch

#endif
