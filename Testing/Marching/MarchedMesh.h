// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A grid made ready for the march of the shaders on the CPU
 */
#ifndef tetmarch_testing_MarchedMesh_h
#define tetmarch_testing_MarchedMesh_h

#include "Mesh/TetMesh.h"
#include "Optics/AccuracyLevel.h"
#include "Optics/IntegralTable.h"

#include "GridBuilder.h"

#include <array>
#include <functional>

namespace tetmarch::testing
{
/// The mesh of a grid; throws std::runtime_error if it can't be built.
TetMesh built(vtkUnstructuredGrid* grid);
/// The same with a hierarchy, convex or not.
TetMesh builtWithHierarchy(vtkUnstructuredGrid* grid);

/// The mesh itself as a grid of tetrahedra in its normalised frame, with the active point scalars
/// of its vertices.
Grid asGrid(const TetMesh& mesh);

/// Colour and extinction of f(0..1), sampled.
IntegralTable tableOf(const std::function<std::array<double, 4>(double)>& f, int entries = 1024);
/// White of extinction 1.
const IntegralTable& whiteTable();

/// A kernel that marches the mesh through a table of the scalars 0..1.
template <typename Kernel, typename Real>
Kernel kernelOf(
  const TetMesh& mesh, const IntegralTable& table, const AccuracyLevel& level = YardstickAccuracy)
{
  Kernel kernel;
  kernel.Mesh = &mesh;
  kernel.Table = &table;
  kernel.tetCount = mesh.numberOfTets();
  kernel.bvhNodeCount = static_cast<int>(mesh.Hierarchy.size());
  kernel.bvhReentryNodeCount = static_cast<int>(mesh.ReentryNodes);
  kernel.reentryFaceCount = static_cast<int>(mesh.ReentryFaces);
  kernel.mostCells = mostCellsOf(static_cast<int>(mesh.Tets.size()));
  kernel.tableSize = table.size();
  kernel.tableScale = Real(table.scale(1.0));
  kernel.tableOffset = Real(table.offset(0.0));
  const auto& unit = table.IntegralUnit;
  kernel.tableIntegralUnit = { Real(unit[0]), Real(unit[1]), Real(unit[2]), Real(unit[3]) };
  kernel.mostTrials = level.MostTrials;
  kernel.errorTolerance = Real(level.ErrorTolerance);
  return kernel;
}
} // namespace tetmarch::testing

#endif
