// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/MeshStage.h"

#include "Caching/WithinMemory.h"
#include "Input/DataCheck.h"
#include "Mesh/CurvilinearMesh.h"
#include "Mesh/HalfFaceLinks.h"
#include "Mesh/LeastTetrahedra.h"
#include "Mesh/MeshSizes.h"
#include "Mesh/MovedPoints.h"

#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

namespace tetmarch
{
namespace
{

// Code that changes the values of an array may call only Modified() of the grid.
Fingerprint attemptOf(vtkPointSet* grid, const ResourceLimits& limits, const PieceOptions& piece)
{
  Fingerprint attempt = versionOf(grid);
  add(attempt, grid);
  attempt.push_back(limits.TexelsPerBuffer);
  attempt.push_back(limits.Bytes);
  attempt.push_back(piece.SeparatePoints ? 1 : 0);
  attempt.push_back(piece.SeparateSides ? 1 : 0);
  if (piece.ByCoordinates)
  {
    attempt.push_back(piece.IsPiece ? 1 : 0);
    addAll(attempt, piece.Frame.Center);
    add(attempt, piece.Frame.Radius);
    attempt.push_back(piece.InFloat ? 1 : 0);
  }
  return attempt;
}

std::string excessOf(vtkUnstructuredGrid* grid, const ResourceLimits& limits)
{
  const std::uint64_t least = leastTetrahedra(grid, mostTetrahedra(limits));
  return describeExcess(leastBufferSizes(least), limits, SizesAre::LowerBounds);
}

} // namespace

bool MeshStage::isCurrent(vtkPointSet* grid, const PieceOptions& piece)
{
  if (this->IsMade)
  {
    this->Asked.read(grid);
  }
  return this->IsMade && this->MadeAs == piece && this->Asked == this->MadeFrom;
}

bool MeshStage::hasCellsOf(vtkPointSet* grid)
{
  return !this->isCurrent(grid) && this->IsMade && this->Asked.hasCellsOf(this->MadeFrom);
}

std::string MeshStage::make(vtkPointSet* grid, const ResourceLimits& limits,
  const Progress& progress, const PieceOptions& piece)
{
  const Fingerprint attempt = attemptOf(grid, limits, piece);
  if (attempt == this->FailedAttempt)
  {
    return this->Error;
  }
  // The frame of the moved points would be their own.
  const bool cellsStay = !piece.IsPiece && !this->MadeAs.IsPiece &&
                         piece.SeparatePoints == this->MadeAs.SeparatePoints &&
                         this->hasCellsOf(grid);
  this->IsMade = false;
  if (!cellsStay)
  {
    this->Mesh = {};
  }
  auto* stored = vtkUnstructuredGrid::SafeDownCast(grid);
  std::string error = stored ? excessOf(stored, limits) : checkData(grid);
  BuildStatus status = BuildStatus::Failed;
  if (error.empty())
  {
    StageRecorder recorder(this->Record);
    const std::string shortage = withinMemory("preparing the mesh",
      [&]
      {
        status = !stored ? this->makeCurvilinear(
                             vtkStructuredGrid::SafeDownCast(grid), limits, progress, piece, error)
                 : cellsStay && movePoints(stored, this->Mesh)
                   ? BuildStatus::Done
                   : buildTetMesh(stored, progress, this->Mesh, error, piece);
        if (status == BuildStatus::Done)
        {
          this->Asked.read(grid);
        }
      });
    if (!shortage.empty())
    {
      error = shortage + " It is tried again when the grid is Modified().";
    }
  }
  this->FailedAttempt.clear();
  if (status == BuildStatus::Done)
  {
    this->MadeFrom = this->Asked;
    this->MadeAs = piece;
    this->IsMade = true;
    return {};
  }
  this->Mesh = {};
  if (status == BuildStatus::Failed)
  {
    this->FailedAttempt = attempt;
    this->Error = error;
  }
  return error;
}

// If the cells can't be computed, they are stored.
BuildStatus MeshStage::makeCurvilinear(vtkStructuredGrid* grid, const ResourceLimits& limits,
  const Progress& progress, const PieceOptions& piece, std::string& error)
{
  const BuildStatus status =
    buildCurvilinearMesh(grid, progress, !piece.SeparateSides, this->Mesh, error);
  if (status != BuildStatus::Done || !this->Mesh.Tets.empty())
  {
    return status;
  }
  const vtkSmartPointer<vtkUnstructuredGrid> hexahedra = hexahedraOf(grid);
  error = excessOf(hexahedra, limits);
  return error.empty() ? buildTetMesh(hexahedra, progress, this->Mesh, error, piece)
                       : BuildStatus::Failed;
}

std::string MeshStage::addHierarchy()
{
  std::vector<std::array<Id, 4>> faces;
  const std::string shortage = withinMemory("the search tree that a camera in the mesh needs",
    [&]
    {
      faces = this->Mesh.BoundaryFaces;
      ensureHierarchy(this->Mesh);
    });
  if (!shortage.empty())
  {
    this->Mesh.Hierarchy = {};
    this->Mesh.ReentryNodes = 0;
    this->Mesh.ReentryFaces = 0;
    if (!faces.empty()) // building the tree reorders them
    {
      this->Mesh.BoundaryFaces.swap(faces);
      linkBoundary(this->Mesh);
    }
  }
  return shortage;
}

} // namespace tetmarch
