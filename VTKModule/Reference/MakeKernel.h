// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A kernel of Kernel.h with all that the GPU has as uniforms and buffers.
#ifndef TetMarchReferenceMakeKernel_h
#define TetMarchReferenceMakeKernel_h

#include "Mesh/TetMesh.h"
#include "Optics/AccuracyLevel.h"
#include "Optics/IntegralTable.h"
#include "Scalars/StoredScalar.h"

namespace tetmarch
{

/** The mesh and the table are referred to, not copied. */
template <typename Kernel, typename Real>
Kernel makeKernel(const TetMesh& mesh, const IntegralTable& table, const ScalarRange& range,
  const AccuracyLevel& level)
{
  Kernel kernel;
  kernel.Mesh = &mesh;
  kernel.Table = &table;
  kernel.tetCount = mesh.numberOfTets();
  kernel.bvhNodeCount = static_cast<int>(mesh.Hierarchy.size());
  kernel.bvhReentryNodeCount = static_cast<int>(mesh.ReentryNodes);
  kernel.reentryFaceCount = static_cast<int>(mesh.ReentryFaces);
  kernel.mostCells = mostCellsOf(mesh.numberOfTets());
  kernel.tableSize = table.size();
  kernel.tableScale = Real(table.scale(range.width()));
  kernel.tableOffset = Real(table.offset(range.Low));
  const auto& ranges = table.Traits.Transparent;
  kernel.transparentRanges = { Real(ranges[0]), Real(ranges[1]), Real(ranges[2]), Real(ranges[3]) };
  const auto& unit = table.IntegralUnit;
  kernel.tableIntegralUnit = { Real(unit[0]), Real(unit[1]), Real(unit[2]), Real(unit[3]) };
  kernel.mostTrials = level.MostTrials;
  kernel.errorTolerance = Real(level.ErrorTolerance);
  return kernel;
}

/** What a scene has of cells, and of scalars that are not finite. */
template <typename Scene, typename Kernel>
void useScalars(const Scene& scene, Kernel& kernel)
{
  using Real = decltype(kernel.tableScale);
  kernel.CellScalars = scene.CellScalars ? scene.CellScalars->data() : nullptr;
  kernel.HiddenCells = scene.Hidden && !scene.Hidden->empty() ? scene.Hidden->data() : nullptr;
  if (scene.NanShown)
  {
    const auto& color = scene.Table->NanColor;
    kernel.nanColor = { Real(color[0]), Real(color[1]), Real(color[2]), Real(color[3]) };
  }
}

} // namespace tetmarch

#endif
