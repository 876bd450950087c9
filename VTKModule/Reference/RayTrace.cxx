// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/RayTrace.h"

#include "Reference/ReferenceImage.h"

#include <algorithm>
#include <limits>

namespace tetmarch
{
namespace
{

double inData(double stored, const ScalarRange& range)
{
  return stored < double(UndrawnScalar) ? range.Low + range.width() * stored
                                        : std::numeric_limits<double>::quiet_NaN();
}

bool areNeighbours(const TetMesh& mesh, Id a, Id b)
{
  constexpr std::array<std::size_t, 4> faces{ 0, 1, 2, 3 };
  return std::any_of(faces.begin(), faces.end(),
    [&](std::size_t face) { return mesh.Links[4 * std::size_t(a) + face] / 4 == b; });
}

// What the mesh and the data say of a cell, beside what the march knows.
void describe(const ReferenceScene& scene, TracedCell& cell)
{
  // Of a lattice the caller knows the cell of the data.
  cell.Cell = scene.Mesh ? scene.Mesh->TetCells[cell.Tet] : static_cast<Id>(cell.Tet);
  std::vector<ScalarRange> ranges{ scene.Range };
  if (scene.Parts)
  {
    const auto& extra = scene.Parts->ExtraRanges;
    ranges.insert(ranges.end(), extra.begin(), extra.end());
  }
  for (std::size_t k = 0; k < ranges.size(); ++k)
  {
    cell.ScalarEnter[k] = inData(cell.ScalarEnter[k], ranges[k]);
    cell.ScalarLeave[k] = inData(cell.ScalarLeave[k], ranges[k]);
  }
}

} // namespace

template <typename Real>
RayTrace traceRay(const ReferenceScene& scene, const AccuracyLevel& level, int x, int y)
{
  RayTrace trace;
  trace.X = x;
  trace.Y = y;
  trace.Components = scene.Parts ? scene.Parts->count() : 1;
  ReferenceScene traced = scene;
  traced.Trace = &trace;
  trace.Counters = renderReference<Real>(traced, level).Counters;
  for (std::size_t i = 0; i < trace.Cells.size(); ++i)
  {
    TracedCell& cell = trace.Cells[i];
    describe(scene, cell);
    cell.EntersMesh =
      i == 0 || (scene.Mesh && !areNeighbours(*scene.Mesh, trace.Cells[i - 1].Tet, cell.Tet));
  }
  return trace;
}

template RayTrace traceRay<float>(const ReferenceScene&, const AccuracyLevel&, int, int);
template RayTrace traceRay<double>(const ReferenceScene&, const AccuracyLevel&, int, int);

} // namespace tetmarch
