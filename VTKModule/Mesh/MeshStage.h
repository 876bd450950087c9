// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The mesh of a grid, made again when the grid changed.
#ifndef TetMarchMeshMeshStage_h
#define TetMarchMeshMeshStage_h

#include "Budget/ResourceLimits.h"
#include "Caching/Fingerprint.h"
#include "Caching/StageRecord.h"
#include "Input/GridContent.h"
#include "Mesh/PieceOptions.h"
#include "Mesh/Progress.h"
#include "Mesh/TetMesh.h"

#include <string>

class vtkUnstructuredGrid;

namespace tetmarch
{

class MeshStage
{
public:
  /** Whether the mesh is that of the grid, or of another one with the same values. */
  bool isCurrent(vtkUnstructuredGrid* grid, const PieceOptions& piece = {});
  /**
   * Returns an empty string, or what is wrong and what to do. The mesh is empty then, and also if
   * progress asked to stop. What failed is not tried again as long as grid and limits stay.
   */
  std::string make(vtkUnstructuredGrid* grid, const ResourceLimits& limits,
    const Progress& progress, const PieceOptions& piece = {});
  /** Add the hierarchy of a convex mesh. Returns an empty string, or why it failed; the mesh stays
   * as it was then. */
  std::string addHierarchy();

  const TetMesh& mesh() const { return this->Mesh; }
  /** For scalars, which are part of the vertices. */
  TetMesh& mesh() { return this->Mesh; }
  const StageRecord& record() const { return this->Record; }

private:
  bool hasCellsOf(
    vtkUnstructuredGrid* grid); // whether the grid differs from that of the mesh in its points only

  TetMesh Mesh;
  bool IsMade = false;
  GridContent MadeFrom;
  PieceOptions MadeAs;
  GridContent Asked; // of the last grid that isCurrent() was asked about
  Fingerprint FailedAttempt;
  std::string Error; // of the failed attempt
  StageRecord Record;
};

} // namespace tetmarch

#endif
