// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The blend modes against closed forms: a linear field in the unit cube, rays of all kinds.
#include "BlendedRays.h"

#include <cmath>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

const Field AlongX = [](double x, double, double) { return x; };
// Stored positions, scalars and tables are floats; short chords make the most of it.
constexpr double ByDouble = 4e-6;
constexpr double ByFloat = 1e-4;

Rgba gray(double value) { return { { value, value, value, 1 } }; }

// Of opacity(s) s from p to q.
double meanIntensity(double p, double q)
{
  const auto integral = [](double s) { return 0.1 * s * s + 0.2 * s * s * s; };
  return std::abs(q - p) < 1e-9 ? BlendedRays::opacity(p) * p
                                : (integral(q) - integral(p)) / (q - p);
}

// All rays have the colours that `expected` says.
template <typename Kernel, typename Real, typename Expected>
void expectRays(const BlendedRays& rays, const Field& field, const Expected& expected)
{
  const double bound = std::is_same<Real, double>::value ? ByDouble : ByFloat;
  auto kernel = rays.kernel<Kernel, Real>();
  int count = 0;
  rays.forEachRay<Kernel, Real>(kernel, field,
    [&](const typename Kernel::Ray& ray, const Chord& chord)
    {
      Rgba known{};
      if (!expected(chord, known))
      {
        return;
      }
      ++count;
      const Rgba found = BlendedRays::cast<Kernel, Real>(kernel, ray, chord);
      for (int k = 0; k < 4; ++k)
      {
        ASSERT_NEAR(found[k], known[k], bound) << "channel " << k << " of ray " << count;
      }
    });
  EXPECT_GT(count, 150);
}

TEST(Blend, MaximumAndMinimum)
{
  BlendedRays rays(jitteredLattice(5, 0.15, 1, linearField()));
  for (const bool greatest : { true, false })
  {
    rays.use(greatest ? BlendMode::Maximum : BlendMode::Minimum);
    const auto expected = [greatest](const Chord& c, Rgba& known)
    {
      known = BlendedRays::premultiplied(
        greatest ? std::max(c.First, c.Last) : std::min(c.First, c.Last));
      return true;
    };
    expectRays<ExtremePointKernel<double>, double>(rays, linearField(), expected);
    expectRays<ExtremePointKernel<float>, float>(rays, linearField(), expected);
  }
}

TEST(Blend, AdditiveIsTheIntegralUpToOne)
{
  BlendedRays rays(jitteredLattice(5, 0.15, 1, linearField()));
  rays.use(BlendMode::Additive, { { 0.5, 0.6 } }); // a range of averages alone
  int clamped = 0;
  const auto expected = [&](const Chord& c, Rgba& known)
  {
    const double sum = meanIntensity(c.First, c.Last) * c.Optical;
    clamped += sum > 1 ? 1 : 0;
    known = gray(std::min(sum, 1.0));
    return true;
  };
  expectRays<SumPointKernel<double>, double>(rays, linearField(), expected);
  expectRays<SumPointKernel<float>, float>(rays, linearField(), expected);
  EXPECT_GT(clamped, 10);
}

TEST(Blend, AverageOverTheRange)
{
  BlendedRays rays(jitteredLattice(5, 0.15, 1, linearField()));
  for (const std::array<double, 2>& range : { std::array<double, 2>{ { -1e38, 1e38 } },
         std::array<double, 2>{ { 0.4, 0.55 } }, std::array<double, 2>{ { 0.5, 7.0 } } })
  {
    rays.use(BlendMode::Average, range);
    const auto expected = [&](const Chord& c, Rgba& known)
    {
      const double low = std::max(std::min(c.First, c.Last), range[0]);
      const double high = std::min(std::max(c.First, c.Last), range[1]);
      if (high > low)
      {
        known = gray(meanIntensity(low, high));
      }
      return std::abs(high - low) > 1e-3; // else rounding decides whether there is anything
    };
    expectRays<SumPointKernel<double>, double>(rays, linearField(), expected);
    expectRays<SumPointKernel<float>, float>(rays, linearField(), expected);
  }
}

TEST(Blend, AverageOfNothingIsNothing)
{
  BlendedRays rays(jitteredLattice(3, 0.15, 1, linearField()));
  for (const std::array<double, 2>& range : { std::array<double, 2>{ { 0.7, 0.3 } },
         std::array<double, 2>{ { 2.0, 3.0 } }, std::array<double, 2>{ { std::nan(""), 1.0 } } })
  {
    rays.use(BlendMode::Average, range);
    expectRays<SumPointKernel<float>, float>(rays, linearField(),
      [](const Chord&, Rgba& known)
      {
        known = {};
        return true;
      });
  }
}

// The values that lie between two scalars, in the order in which they are met.
std::vector<double> crossed(std::vector<double> values, const Chord& c)
{
  std::sort(values.begin(), values.end());
  if (c.Last < c.First)
  {
    std::reverse(values.begin(), values.end());
  }
  std::vector<double> met;
  for (double v : values)
  {
    if ((v > c.First) != (v > c.Last) && (met.empty() || met.back() != v))
    {
      met.push_back(v);
    }
  }
  return met;
}

Rgba composited(const std::vector<double>& values)
{
  Rgba color{};
  for (double v : values)
  {
    const Rgba next = BlendedRays::premultiplied(v);
    const double seen = 1 - color[3];
    for (int k = 0; k < 4; ++k)
    {
      color[k] += seen * next[k];
    }
  }
  return color;
}

TEST(Blend, IsosurfacesInTheOrderOfDepth)
{
  BlendedRays rays(jitteredLattice(3, 0.15, 1, linearField()));
  for (const std::vector<double>& values :
    { std::vector<double>{ 0.5 }, std::vector<double>{ 0.7, 0.31, 0.52, 0.52, 0.55 },
      std::vector<double>{ 0.9, -1.0, 3.0 }, std::vector<double>{} })
  {
    EXPECT_EQ(rays.useSurfaces(values), "");
    const auto expected = [&](const Chord& c, Rgba& known)
    {
      known = composited(crossed(values, c));
      return std::none_of(values.begin(), values.end(),
        [&](double v) { return std::abs(v - c.First) < 1e-5 || std::abs(v - c.Last) < 1e-5; });
    };
    expectRays<IsosurfacePointKernel<double>, double>(rays, linearField(), expected);
    expectRays<IsosurfacePointKernel<float>, float>(rays, linearField(), expected);
  }
}

// The value is that of all points of a plane of faces; rays go through vertices, along edges and in
// faces of the lattice, too. In the plane itself it may or may not be crossed.
TEST(Blend, AValueOnFacesCountsOnce)
{
  BlendedRays rays(jitteredLattice(4, 0.0, 1, AlongX));
  rays.useSurfaces({ 0.25, 0.5 });
  const auto expected = [&](const Chord& c, Rgba& known)
  {
    known = composited(crossed({ 0.25, 0.5 }, c));
    const double nearest = std::min(std::min(std::abs(c.First - 0.25), std::abs(c.First - 0.5)),
      std::min(std::abs(c.Last - 0.25), std::abs(c.Last - 0.5)));
    return nearest > 1e-5 && std::abs(c.First - c.Last) > 1e-5;
  };
  expectRays<IsosurfacePointKernel<double>, double>(rays, AlongX, expected);
  expectRays<IsosurfacePointKernel<float>, float>(rays, AlongX, expected);
}

// Of cells, constant in four slabs along x.
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

// A hundred thousandth beside a slab's side it is not sure on which side rounding leaves it.
bool isBesideASide(double x) { return std::abs(4 * x - std::round(4 * x)) < 1e-4; }

TEST(Blend, ScalarsOfCells)
{
  BlendedRays rays(slabs(), true);
  const auto sure = [](const Chord& c)
  {
    const bool ends = (c.First < 1e-4 || c.First > 1 - 1e-4 || !isBesideASide(c.First)) &&
                      (c.Last < 1e-4 || c.Last > 1 - 1e-4 || !isBesideASide(c.Last));
    return ends && std::abs(c.First - c.Last) > 1e-3;
  };
  rays.use(BlendMode::Maximum);
  const auto maximum = [&](const Chord& c, Rgba& known)
  {
    known = BlendedRays::premultiplied(scalarOfSlab(std::max(c.First, c.Last)));
    return sure(c);
  };
  expectRays<ExtremeCellKernel<double>, double>(rays, AlongX, maximum);
  expectRays<ExtremeCellKernel<float>, float>(rays, AlongX, maximum);

  rays.use(BlendMode::Average, { { 0.3, 0.9 } });
  const auto average = [&](const Chord& c, Rgba& known)
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

  // Between two slabs each; a third and two thirds are scalars of slabs.
  const std::vector<double> values{ 0.1, 0.2, 0.5, 0.9 };
  rays.useSurfaces(values);
  const auto surfaces = [&](const Chord& c, Rgba& known)
  {
    Chord stepped = c;
    stepped.First = scalarOfSlab(c.First);
    stepped.Last = scalarOfSlab(c.Last);
    known = composited(crossed(values, stepped));
    return sure(c);
  };
  expectRays<IsosurfaceCellKernel<double>, double>(rays, AlongX, surfaces);
  expectRays<IsosurfaceCellKernel<float>, float>(rays, AlongX, surfaces);
}

// Between two parts of a mesh, or beyond cells without a scalar, the scalar passes no value.
TEST(Blend, NoSurfaceAcrossAGap)
{
  const auto expectNothing = [](const Grid& grid)
  {
    BlendedRays points(grid);
    points.useSurfaces({ 0.5 });
    expectRays<IsosurfacePointKernel<double>, double>(points, AlongX,
      [](const Chord&, Rgba& known)
      {
        known = {};
        return true;
      });
    BlendedRays cells(grid, true);
    cells.useSurfaces({ 0.5 });
    expectRays<IsosurfaceCellKernel<double>, double>(cells, AlongX,
      [](const Chord&, Rgba& known)
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

TEST(Blend, ScalarsThatAreNotFiniteDoNotCount)
{
  Grid grid = jitteredLattice(4, 0.0, 1, AlongX);
  vtkDataArray* values = grid->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const double x = values->GetComponent(i, 0);
    values->SetComponent(i, 0, x > 0.6 && x < 0.9 ? std::nan("") : x);
  }
  BlendedRays rays(grid);
  rays.use(BlendMode::Maximum);
  expectRays<ExtremePointKernel<double>, double>(rays, AlongX,
    [](const Chord& c, Rgba& known)
    {
      const double low = std::min(c.First, c.Last);
      known =
        low < 0.5 ? BlendedRays::premultiplied(std::min(std::max(c.First, c.Last), 0.5)) : Rgba{};
      return std::abs(low - 0.5) > 1e-4;
    });
}
} // namespace
