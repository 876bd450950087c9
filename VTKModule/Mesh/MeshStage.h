// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The mesh of a grid, made again when the grid has changed.
#ifndef TetMarchMeshMeshStage_h
#define TetMarchMeshMeshStage_h

#include "Budget/ResourceLimits.h"
#include "Caching/Fingerprint.h"
#include "Caching/StageRecord.h"
#include "Input/GridContent.h"
#include "Mesh/PieceOptions.h"
#include "Mesh/TetMesh.h"
#include "Mesh/TetMeshBuilder.h"
#include "Parallel/Progress.h"

#include <string>

class vtkPointSet;
class vtkStructuredGrid;

namespace tetmarch
{

class MeshStage
{
public:
  /** Whether the mesh belongs to the grid, or to another one with the same values. */
  bool isCurrent(vtkPointSet* grid, const PieceOptions& piece = {});
  /**
   * Returns an empty string, or an error with its remedy. The mesh is then empty, and also if
   * progress requested a stop. A failed attempt is not repeated until the grid or the limits
   * change.
   */
  std::string make(vtkPointSet* grid, const ResourceLimits& limits, const Progress& progress,
    const PieceOptions& piece = {});
  /** Add the hierarchy. Returns an empty string, or an error; the mesh is then unchanged. */
  std::string addHierarchy();

  const TetMesh& mesh() const { return this->Mesh; }
  /** Mutable for scalars, which are part of the vertices. */
  TetMesh& mesh() { return this->Mesh; }
  const StageRecord& record() const { return this->Record; }

private:
  bool hasCellsOf(
    vtkPointSet* grid); // whether only the points of the grid differ from those of the mesh
  BuildStatus makeCurvilinear(vtkStructuredGrid* grid, const ResourceLimits& limits,
    const Progress& progress, const PieceOptions& piece, std::string& error);

  TetMesh Mesh;
  bool IsMade = false;
  GridContent MadeFrom;
  PieceOptions MadeAs;
  GridContent Asked; // of the last grid of isCurrent()
  Fingerprint FailedAttempt;
  std::string Error; // of the failed attempt
  StageRecord Record;
};

} // namespace tetmarch

#endif
