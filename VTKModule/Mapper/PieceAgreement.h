// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the processes that draw a volume together agree on, stage by stage.
#ifndef TetMarchMapperPieceAgreement_h
#define TetMarchMapperPieceAgreement_h

#include "Mesh/PieceOptions.h"
#include "Optics/AccuracyLevel.h"
#include "Processes/SharedPicture.h"
#include "Scalars/DrawnScalars.h"

#include "vtkBoundingBox.h"

class vtkUnstructuredGrid;

namespace tetmarch
{

/** What a mapper keeps of the group from frame to frame. */
struct GroupState
{
  Group Processes;
  bool HasController = false; // the group may have more processes than one
  std::uint64_t MostVisitBytes = 0;
  SharedPicture Shared;           // of the last frame
  PieceOptions Piece;             // likewise
  std::vector<FiniteRange> Whole; // ranges of its scalars
  vtkBoundingBox WholeBox;
  /** A number that is the same in all processes, and another one if the mesh or the scalars of one
   * of them have changed, or something was wrong. */
  std::uintptr_t Generation = 0;
  Fingerprint Version; // of mesh and scalars of this process, in the last frame
};

/** What holds for a frame of all processes. */
struct WholeVolume
{
  bool IsEmpty = true; // no process has cells
  vtkBoundingBox Box;  // of all cells
  PieceOptions Piece;
  AccuracyLevel Level = DefaultAccuracy;
  double SampleDistance = 1;
};

// All of these are collective. `own` is where this process is so far.

/** The box of all processes' boxes. */
vtkBoundingBox wholeBox(Group& group, const vtkBoundingBox& own);

/** The frame of the cells of all grids, of which own one may be nullptr; accuracy and distance of
 * rays as process 0 has them; faces cut by coordinates if a process with cells asks for it. Returns
 * an empty string, or what is wrong with any process. */
std::string agreeOnWhole(
  Group& group, const std::string& own, vtkUnstructuredGrid* grid, WholeVolume& whole);

/** The kind and the ranges of the scalars, those that this process draws being of the ranges. A
 * process without a piece takes what the others draw. Returns where all are. */
PartStatus agreeOnScalars(Group& group, const PartStatus& own, bool hasPiece,
  const std::vector<FiniteRange>& ranges, DrawnScalars& drawn);

/** Why nothing is visible of any piece, by the first process with a piece; empty if something may
 * be visible. `own` is likewise of this process's piece. */
std::string agreeOnNothingVisible(Group& group, bool hasPiece, const std::string& own);

} // namespace tetmarch

#endif
