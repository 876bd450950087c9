// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A hard case made ready for rays: mesh with hierarchy, scalars, table, what lengths are
 * held against
 */
#ifndef tetmarch_testing_MarchedCase_h
#define tetmarch_testing_MarchedCase_h

#include "HardCase.h"

#include "Mesh/TetMesh.h"
#include "Optics/IntegralTable.h"
#include "Scalars/StoredScalar.h"

#include <memory>

namespace tetmarch::testing
{
class GroundTruthScene;

struct MarchedCase
{
  /// Throws std::runtime_error if the mesh can't be built. The case is referred to, not copied.
  explicit MarchedCase(const HardCase& hard);
  ~MarchedCase();

  const HardCase& Case;
  TetMesh Mesh;
  std::vector<float> CellScalars; ///< empty: those of the vertices count
  ScalarRange Range;
  IntegralTable Table;
  double UnitDistance = 1.0;                    ///< in mesh radii
  Box NormalizedBox{};                          ///< that the cells fill, if they do
  std::vector<TetMesh> Displaced;               ///< copies with other positions
  std::unique_ptr<GroundTruthScene> BruteForce; ///< if the answer is the union of all cells

private:
  void makeOptics(vtkUnstructuredGrid* grid);
  void makeAnswers();
};
} // namespace tetmarch::testing

#endif
