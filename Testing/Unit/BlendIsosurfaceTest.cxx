// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Isosurfaces against closed forms: in the order of depth, each counted once, none across a gap.
#include "Reference/IsosurfacesCellKernel.h"
#include "Reference/IsosurfacesPointKernel.h"

#include "BlendedColors.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

TEST(Blend, IsosurfacesInTheOrderOfDepth)
{
  BlendedRays rays(jitteredLattice(3, 0.15, 1, linearField()));
  for (const std::vector<double>& values :
    { std::vector<double>{ 0.5 }, std::vector<double>{ 0.7, 0.31, 0.52, 0.52, 0.55 },
      std::vector<double>{ 0.9, -1.0, 3.0 }, std::vector<double>{} })
  {
    EXPECT_EQ(rays.useSurfaces(values), "");
    const auto expected = [&](const ScalarChord& c, Rgba& known)
    {
      known = composited(crossed(values, c));
      return std::none_of(values.begin(), values.end(),
        [&](double v) { return std::abs(v - c.First) < 1e-5 || std::abs(v - c.Last) < 1e-5; });
    };
    expectRays<IsosurfacesPointKernel<double>, double>(rays, linearField(), expected);
    expectRays<IsosurfacesPointKernel<float>, float>(rays, linearField(), expected);
  }
}

// A plane of faces has the value everywhere. Rays go through its vertices, along its edges and in
// its faces, too; in the plane itself the value may count or not.
TEST(Blend, AValueOnFacesCountsOnce)
{
  BlendedRays rays(jitteredLattice(4, 0.0, 1, AlongX));
  rays.useSurfaces({ 0.25, 0.5 });
  const auto expected = [&](const ScalarChord& c, Rgba& known)
  {
    known = composited(crossed({ 0.25, 0.5 }, c));
    const double nearest = std::min(std::min(std::abs(c.First - 0.25), std::abs(c.First - 0.5)),
      std::min(std::abs(c.Last - 0.25), std::abs(c.Last - 0.5)));
    return nearest > 1e-5 && std::abs(c.First - c.Last) > 1e-5;
  };
  expectRays<IsosurfacesPointKernel<double>, double>(rays, AlongX, expected);
  expectRays<IsosurfacesPointKernel<float>, float>(rays, AlongX, expected);
}

// Between two parts of a mesh, or beyond cells without a scalar, the scalar passes no value.
TEST(Blend, NoSurfaceAcrossAGap)
{
  const auto expectNothing = [](const Grid& grid)
  {
    BlendedRays points(grid);
    points.useSurfaces({ 0.5 });
    expectRays<IsosurfacesPointKernel<double>, double>(points, AlongX,
      [](const ScalarChord&, Rgba& known)
      {
        known = {};
        return true;
      });
    BlendedRays cells(grid, true);
    cells.useSurfaces({ 0.5 });
    expectRays<IsosurfacesCellKernel<double>, double>(cells, AlongX,
      [](const ScalarChord&, Rgba& known)
      {
        known = {};
        return true;
      });
  };
  expectNothing(maskedLattice(4, 0.0, 1, AlongX, [](int i, int, int) { return i == 0 || i == 3; }));
  Grid undrawn = jitteredLattice(4, 0.0, 1, AlongX);
  for (vtkDataArray* values :
    { undrawn->GetPointData()->GetScalars(), undrawn->GetCellData()->GetScalars() })
  {
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      const double x = values->GetComponent(i, 0);
      values->SetComponent(i, 0, x > 0.3 && x < 0.7 ? std::nan("") : x);
    }
  }
  expectNothing(undrawn);
}
} // namespace
