// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The blend modes against closed forms where scalars are constant in cells.
#include "Reference/ExtremeCellKernel.h"
#include "Reference/IsosurfacesCellKernel.h"
#include "Reference/SumCellKernel.h"

#include "BlendedColors.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

// Scalars of cells, constant in four slabs along x.
Grid slabs()
{
  Grid grid = jitteredLattice(4, 0.0, 1, AlongX);
  vtkDataArray* cells = grid->GetCellData()->GetScalars();
  for (vtkIdType i = 0; i < cells->GetNumberOfTuples(); ++i)
  {
    cells->SetComponent(i, 0, std::floor(4 * cells->GetComponent(i, 0)) / 3);
  }
  return grid;
}

double scalarOfSlab(double x) { return std::floor(std::min(std::max(4 * x, 0.0), 3.999)) / 3; }

// So near to the side of a slab, rounding decides on which side a point lies.
bool isBesideASide(double x) { return std::abs(4 * x - std::round(4 * x)) < 1e-4; }

TEST(Blend, ScalarsOfCells)
{
  BlendedRays rays(slabs(), true);
  const auto sure = [](const ScalarChord& c)
  {
    const bool ends = (c.First < 1e-4 || c.First > 1 - 1e-4 || !isBesideASide(c.First)) &&
                      (c.Last < 1e-4 || c.Last > 1 - 1e-4 || !isBesideASide(c.Last));
    return ends && std::abs(c.First - c.Last) > 1e-3;
  };
  rays.use(BlendMode::Maximum);
  const auto maximum = [&](const ScalarChord& c, Rgba& known)
  {
    known = BlendedRays::premultiplied(scalarOfSlab(std::max(c.First, c.Last)));
    return sure(c);
  };
  expectRays<ExtremeCellKernel<double>, double>(rays, AlongX, maximum);
  expectRays<ExtremeCellKernel<float>, float>(rays, AlongX, maximum);

  rays.use(BlendMode::Average, { { 0.3, 0.9 } });
  const auto average = [&](const ScalarChord& c, Rgba& known)
  {
    double sum = 0, length = 0;
    for (int slab = 1; slab < 3; ++slab)
    {
      const double low = std::max(std::min(c.First, c.Last), slab / 4.0);
      const double high = std::min(std::max(c.First, c.Last), (slab + 1) / 4.0);
      const double counted = std::max(high - low, 0.0);
      length += counted;
      sum += counted * BlendedRays::opacity(slab / 3.0) * slab / 3.0;
    }
    if (length > 0)
    {
      known = gray(sum / length);
    }
    return sure(c) && (length == 0 || length > 0.01);
  };
  expectRays<SumCellKernel<double>, double>(rays, AlongX, average);

  // Values between the scalars of two slabs, which are 0, 1/3, 2/3 and 1.
  const std::vector<double> values{ 0.1, 0.2, 0.5, 0.9 };
  rays.useSurfaces(values);
  const auto surfaces = [&](const ScalarChord& c, Rgba& known)
  {
    ScalarChord stepped = c;
    stepped.First = scalarOfSlab(c.First);
    stepped.Last = scalarOfSlab(c.Last);
    known = composited(crossed(values, stepped));
    return sure(c);
  };
  expectRays<IsosurfacesCellKernel<double>, double>(rays, AlongX, surfaces);
  expectRays<IsosurfacesCellKernel<float>, float>(rays, AlongX, surfaces);
}
} // namespace
