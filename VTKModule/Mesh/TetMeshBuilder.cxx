// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/TetMeshBuilder.h"

#include "Mesh/BoundaryHierarchy.h"
#include "Mesh/Convexity.h"
#include "Mesh/Decomposition.h"
#include "Mesh/HalfFaceLinks.h"
#include "Mesh/Renumbering.h"

#include "vtkUnstructuredGrid.h"

namespace tetmarch
{

BuildStatus buildTetMesh(vtkUnstructuredGrid* grid, const Progress& progress, TetMesh& mesh,
  std::string& error, const PieceOptions& piece)
{
  mesh = {};
  Decomposition tets;
  bool stopped = false;
  error = decompose(grid, subProgress(progress, 0, 0.2), tets, stopped, piece);
  if (error.empty() && !stopped)
  {
    error = renumber(
      grid->GetPoints(), std::move(tets), subProgress(progress, 0.2, 0.5), mesh, stopped, piece);
  }
  if (!error.empty())
  {
    return BuildStatus::Failed;
  }
  if (stopped || !linkHalfFaces(subProgress(progress, 0.5, 0.95), mesh))
  {
    return BuildStatus::Stopped;
  }
  if (mesh.BoundaryFaces.size() > MostHierarchyFaces)
  {
    error = "The mesh has " + std::to_string(mesh.BoundaryFaces.size()) +
            " boundary faces; at most " + std::to_string(MostHierarchyFaces) +
            " can be rendered. Do neighbouring cells have corners with equal coordinates? "
            "vtkStaticCleanUnstructuredGrid merges points within a tolerance.";
    return BuildStatus::Failed;
  }
  mesh.MayReenter = !isConvex(mesh);
  linkBoundary(mesh);
  return progress && !progress(1.0) ? BuildStatus::Stopped : BuildStatus::Done;
}

void ensureHierarchy(TetMesh& mesh)
{
  if (mesh.Hierarchy.empty())
  {
    buildHierarchy(mesh);
    linkBoundary(mesh);
  }
}

} // namespace tetmarch
