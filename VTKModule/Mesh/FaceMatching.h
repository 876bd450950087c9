// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Finds tetrahedra with a common face.
#ifndef TetMarchMeshFaceMatching_h
#define TetMarchMeshFaceMatching_h

#include "Mesh/TetMesh.h"
#include "Parallel/Progress.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace tetmarch
{

/** A half-face that has no neighbour so far. */
constexpr Id Unlinked = 0xffffffffu;

/** Results of the matching besides the links. */
struct FaceMatching
{
  std::vector<std::int8_t> Signs; // volumeSigns()
  bool Agree = true;              // no sign is 0, and all linked pairs lie on opposite sides
  std::vector<std::pair<Id, Id>> Boundary; // smallest vertex (for the order), half-face
  bool ManyOwners = false;                 // some faces have more than two owners
  vtkIdType NonManifoldFaces = 0;
  /** If not empty, the other faces were not matched: match again without these. */
  std::vector<Id> Duplicates;
  std::vector<Id> Cancelled; // with their duplicates
};

/** Set the links between tetrahedra, treating duplicates and faces with many owners as described in
 * HalfFaceLinks.h. False if progress requested a stop. */
bool matchFaces(const Progress& progress, TetMesh& mesh, FaceMatching& found);

} // namespace tetmarch

#endif
