// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A grid made ready for the march of the shaders on the CPU
 */
#ifndef tetmarch_testing_MarchedMesh_h
#define tetmarch_testing_MarchedMesh_h

#include "Reference/MakeKernel.h"

#include "GridBuilder.h"

#include <array>
#include <functional>

namespace tetmarch::testing
{
/// The mesh of a grid; throws std::runtime_error if it can't be built.
TetMesh built(vtkUnstructuredGrid* grid);
/// The same; points with equal coordinates stay separate.
TetMesh builtApart(vtkUnstructuredGrid* grid);
/// The same as built() with a hierarchy, convex or not.
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
  const TetMesh& mesh, const IntegralTable& table, const AccuracyLevel& level = GroundTruthAccuracy)
{
  return makeKernel<Kernel, Real>(mesh, table, { 0.0, 1.0 }, level);
}
} // namespace tetmarch::testing

#endif
