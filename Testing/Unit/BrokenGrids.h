// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Grids of a few cells to break, and the errors they must give
 */
#ifndef tetmarch_testing_BrokenGrids_h
#define tetmarch_testing_BrokenGrids_h

#include "Mesh/TetMeshBuilder.h"

#include "RawGrid.h"
#include "UnitMeshes.h"

#include "vtkCellType.h"

#include <gtest/gtest.h>

namespace tetmarch::testing
{
using Words = std::vector<std::string>;

/// Building the mesh fails, with an error that says these words.
inline void expectError(vtkUnstructuredGrid* grid, const Words& words)
{
  TetMesh mesh;
  std::string error;
  EXPECT_EQ(buildTetMesh(grid, {}, mesh, error), BuildStatus::Failed);
  for (const std::string& word : words)
  {
    EXPECT_NE(error.find(word), std::string::npos) << "'" << word << "' in: " << error;
  }
}

/// With offsets and connectivity of 32 and of 64 bits.
inline void expectError(RawGrid raw, const Words& words)
{
  for (const bool wide : { false, true })
  {
    SCOPED_TRACE(wide ? "64 bits" : "32 bits");
    raw.Wide = wide;
    expectError(raw.grid(), words);
  }
}

inline void expectSound(const RawGrid& raw, std::size_t tets)
{
  EXPECT_EQ(built(raw.grid()).Tets.size(), tets);
}

/// Points 0..7 are the corners of the unit cube as VTK numbers those of a hexahedron.
inline RawGrid gridOf(const std::vector<std::pair<int, Ids>>& cells)
{
  RawGrid raw;
  raw.Points = { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1 };
  raw.Offsets = { 0 };
  for (const auto& cell : cells)
  {
    raw.Types.push_back(static_cast<unsigned char>(cell.first));
    raw.Connectivity.insert(raw.Connectivity.end(), cell.second.begin(), cell.second.end());
    raw.Offsets.push_back(static_cast<vtkIdType>(raw.Connectivity.size()));
  }
  return raw;
}

inline const std::pair<int, Ids> Tet{ VTK_TETRA, { 0, 1, 3, 4 } };
inline const std::pair<int, Ids> Hexahedron{ VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } };

/// A tetrahedron and a polyhedron of 6 faces with 4 corners each.
inline RawGrid tetAndPolyhedron()
{
  RawGrid raw = gridOf({ Tet, { VTK_POLYHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } } });
  raw.HasFaces = true;
  raw.Faces.addNone();
  raw.Faces.add({ { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 }, { 3, 7, 6, 2 }, { 0, 3, 2, 1 },
    { 4, 5, 6, 7 } });
  return raw;
}
} // namespace tetmarch::testing

#endif
