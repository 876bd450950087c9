// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Meshes for the unit tests, and what is known of them
 */
#ifndef tetmarch_testing_UnitMeshes_h
#define tetmarch_testing_UnitMeshes_h

#include "Grids.h"
#include "MarchedMesh.h"

#include <functional>
#include <vector>

namespace tetmarch::testing
{
/// Six times the signed volume of four of its vertices, in the normalised frame. Differences of
/// floats are exact in double.
double sixVolumes(const TetMesh& mesh, const std::array<Id, 4>& vertices);
/// The volume of all tetrahedra together, in the coordinates of the grid.
double totalVolume(const TetMesh& mesh);

struct NamedGrid
{
  const char* Name;
  std::function<Grid()> Make;
};
/// One or more of every generator of Grids.h that gives a volume.
const std::vector<NamedGrid>& everyGrid();

} // namespace tetmarch::testing

#endif
