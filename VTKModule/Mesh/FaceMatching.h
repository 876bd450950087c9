// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which tetrahedra have a face in common.
#ifndef TetMarchMeshFaceMatching_h
#define TetMarchMeshFaceMatching_h

#include "Mesh/Progress.h"
#include "Mesh/TetMesh.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace tetmarch
{

/** A half-face without a neighbour yet. */
constexpr Id Unlinked = 0xffffffffu;

/** What matching found beside the links. */
struct FaceMatching
{
  std::vector<std::int8_t> Signs; // volumeSigns()
  bool Agree = true;              // none is 0, and all that were joined lie on opposite sides
  std::vector<std::pair<Id, Id>> Boundary; // smallest vertex (for the order), half-face
  bool ManyOwners = false;                 // faces have more than two
  vtkIdType NonManifoldFaces = 0;
  /** If there are any, the rest was not matched: to be done again without them. */
  std::vector<Id> Duplicates;
  std::vector<Id> Cancelled; // with their duplicates
};

/**
 * Set the links between tetrahedra; what is said of duplicates and of faces with many owners in
 * HalfFaceLinks.h happens here. False if progress asked to stop.
 */
bool matchFaces(const Progress& progress, TetMesh& mesh, FaceMatching& found);

} // namespace tetmarch

#endif
