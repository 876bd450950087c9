// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The blend modes against closed forms: a linear field in the unit cube, or one of steps, and rays
// of all kinds.
#include "Reference/ExtremeCellKernel.h"
#include "Reference/ExtremePointKernel.h"
#include "Reference/IsosurfacesCellKernel.h"
#include "Reference/IsosurfacesPointKernel.h"
#include "Reference/SumCellKernel.h"
#include "Reference/SumPointKernel.h"

#include "BlendedColors.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

// The mean of opacity(s) s for s from p to q.
double meanIntensity(double p, double q)
{
  const auto integral = [](double s) { return 0.1 * s * s + 0.2 * s * s * s; };
  return std::abs(q - p) < 1e-9 ? BlendedRays::opacity(p) * p
                                : (integral(q) - integral(p)) / (q - p);
}

TEST(Blend, MaximumAndMinimum)
{
  BlendedRays rays(jitteredLattice(5, 0.15, 1, linearField()));
  for (const bool greatest : { true, false })
  {
    rays.use(greatest ? BlendMode::Maximum : BlendMode::Minimum);
    const auto expected = [greatest](const ScalarChord& c, Rgba& known)
    {
      known = BlendedRays::premultiplied(
        greatest ? std::max(c.First, c.Last) : std::min(c.First, c.Last));
      return true;
    };
    expectRays<ExtremePointKernel>(rays, linearField(), expected);
  }
}

TEST(Blend, AdditiveIsTheIntegralUpToOne)
{
  BlendedRays rays(jitteredLattice(5, 0.15, 1, linearField()));
  rays.use(BlendMode::Additive, { { 0.5, 0.6 } }); // the range is used by averages alone
  int clamped = 0;
  const auto expected = [&](const ScalarChord& c, Rgba& known)
  {
    const double sum = meanIntensity(c.First, c.Last) * c.Optical;
    clamped += sum > 1 ? 1 : 0;
    known = gray(std::min(sum, 1.0));
    return true;
  };
  expectRays<SumPointKernel>(rays, linearField(), expected);
  EXPECT_GT(clamped, 10);
}

TEST(Blend, AverageOverTheRange)
{
  BlendedRays rays(jitteredLattice(5, 0.15, 1, linearField()));
  for (const std::array<double, 2>& range : { std::array<double, 2>{ { -1e38, 1e38 } },
         std::array<double, 2>{ { 0.4, 0.55 } }, std::array<double, 2>{ { 0.5, 7.0 } } })
  {
    rays.use(BlendMode::Average, range);
    const auto expected = [&](const ScalarChord& c, Rgba& known)
    {
      const double low = std::max(std::min(c.First, c.Last), range[0]);
      const double high = std::min(std::max(c.First, c.Last), range[1]);
      if (high > low)
      {
        known = gray(meanIntensity(low, high));
      }
      return std::abs(high - low) > 1e-3; // else rounding decides whether there is anything
    };
    expectRays<SumPointKernel>(rays, linearField(), expected);
  }
}

TEST(Blend, AverageOfNothingIsNothing)
{
  BlendedRays rays(jitteredLattice(3, 0.15, 1, linearField()));
  for (const std::array<double, 2>& range : { std::array<double, 2>{ { 0.7, 0.3 } },
         std::array<double, 2>{ { 2.0, 3.0 } }, std::array<double, 2>{ { std::nan(""), 1.0 } } })
  {
    rays.use(BlendMode::Average, range);
    expectRays<SumPointKernel>(rays, linearField(), knowNothing);
  }
}

// Scalars along x that are not finite between two places.
Grid notFiniteBetween(double low, double high)
{
  Grid grid = jitteredLattice(4, 0.0, 1, AlongX);
  for (vtkDataArray* values :
    { grid->GetPointData()->GetScalars(), grid->GetCellData()->GetScalars() })
  {
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      const double x = values->GetComponent(i, 0);
      values->SetComponent(i, 0, x > low && x < high ? std::nan("") : x);
    }
  }
  return grid;
}

TEST(Blend, ScalarsThatAreNotFiniteDoNotCount)
{
  BlendedRays rays(notFiniteBetween(0.6, 0.9));
  rays.use(BlendMode::Maximum);
  expectRays<ExtremePointKernel>(rays, AlongX,
    [](const ScalarChord& c, Rgba& known)
    {
      const double low = std::min(c.First, c.Last);
      known =
        low < 0.5 ? BlendedRays::premultiplied(std::min(std::max(c.First, c.Last), 0.5)) : Rgba{};
      return std::abs(low - 0.5) > 1e-4;
    });
}

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
    expectRays<IsosurfacesPointKernel>(rays, linearField(), expected);
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
  expectRays<IsosurfacesPointKernel>(rays, AlongX, expected);
}

// Between two parts of a mesh, or beyond cells without a scalar, the scalar passes no value.
TEST(Blend, NoSurfaceAcrossAGap)
{
  const auto expectNothing = [](const Grid& grid)
  {
    BlendedRays points(grid);
    points.useSurfaces({ 0.5 });
    expectRays<IsosurfacesPointKernel>(points, AlongX, knowNothing);
    BlendedRays cells(grid, true);
    cells.useSurfaces({ 0.5 });
    expectRays<IsosurfacesCellKernel>(cells, AlongX, knowNothing);
  };
  expectNothing(maskedLattice(4, 0.0, 1, AlongX, [](int i, int, int) { return i == 0 || i == 3; }));
  expectNothing(notFiniteBetween(0.3, 0.7));
}

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
  expectRays<ExtremeCellKernel>(rays, AlongX, maximum);

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
  expectRays<SumCellKernel>(rays, AlongX, average);

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
  expectRays<IsosurfacesCellKernel>(rays, AlongX, surfaces);
}
} // namespace
