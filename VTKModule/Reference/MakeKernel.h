// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A kernel with what every march reads; useScene() adds the rest.
#ifndef TetMarchReferenceMakeKernel_h
#define TetMarchReferenceMakeKernel_h

#include "Mesh/TetMesh.h"
#include "Optics/AccuracyLevel.h"
#include "Optics/IntegralTable.h"
#include "Scalars/StoredScalar.h"

namespace tetmarch
{

/** Without a volume. The table is referred to, not copied. */
template <typename Kernel, typename Real>
Kernel makeKernel(const IntegralTable& table, const ScalarRange& range, const AccuracyLevel& level)
{
  Kernel kernel;
  kernel.Table = &table;
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

/** The mesh is referred to, too. */
template <typename Kernel, typename Real>
Kernel makeKernel(const TetMesh& mesh, const IntegralTable& table, const ScalarRange& range,
  const AccuracyLevel& level)
{
  auto kernel = makeKernel<Kernel, Real>(table, range, level);
  kernel.useMesh(mesh);
  return kernel;
}

} // namespace tetmarch

#endif
