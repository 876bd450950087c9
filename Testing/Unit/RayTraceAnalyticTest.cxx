// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a trace says of each tetrahedron, against closed forms.
#include "Reference/RayTrace.h"

#include "ClosedForms.h"
#include "Shot.h"

#include "vtkPointData.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

/// Constant colour (1, 1/2, 1/4) and extinction.
OpticalModel constantOptics(double opacity)
{
  return opticalModelOf({ { { 0.0, 1.0, 0.5, 0.25 } } }, { { { 0.0, opacity } } });
}

Field constantField(double scalar)
{
  return [scalar](double, double, double) { return scalar; };
}

/// The point at a depth of the ray, in the coordinates of the grid.
Vec3 pointAt(const TetMesh& mesh, const RayTrace& trace, double depth)
{
  Vec3 point;
  for (int k = 0; k < 3; ++k)
  {
    point[k] =
      mesh.Frame.Center[k] +
      mesh.Frame.Radius * (trace.Origin[k] + (depth - trace.OriginDepth) * trace.Direction[k]);
  }
  return point;
}

/// Where a line o + t d is inside of the tetrahedron x, y, z >= 0, x + y + z <= 1.
std::array<double, 2> chordOfUnitTet(const Vec3& o, const Vec3& d)
{
  double begin = -1e9, end = 1e9;
  const auto cut = [&](double height, double slope)
  {
    (slope > 0.0 ? begin : end) =
      slope > 0.0 ? std::max(begin, -height / slope) : std::min(end, -height / slope);
  };
  for (int k = 0; k < 3; ++k)
  {
    cut(o[k], d[k]);
  }
  cut(1.0 - o[0] - o[1] - o[2], -d[0] - d[1] - d[2]);
  return { { begin, end } };
}

template <typename Real>
void expectUnitTet(double tolerance)
{
  constexpr double scalar = 3.5, opacity = 0.7;
  Shot shot;
  shot.Data = singleTet(constantField(scalar));
  shot.Optics = constantOptics(opacity);
  const MarchedShot marched(shot, DefaultAccuracy);
  const TetMesh& mesh = marched.Mesh;
  int hits = 0, misses = 0;
  for (int pixel = 0; pixel < Shot::Size * Shot::Size; pixel += 7)
  {
    const RayTrace trace =
      traceRay<Real>(marched.Scene, DefaultAccuracy, pixel % Shot::Size, pixel / Shot::Size);
    const auto [begin, end] = chordOfUnitTet(pointAt(mesh, trace, trace.OriginDepth),
      { { trace.Direction[0], trace.Direction[1], trace.Direction[2] } });
    if (end < begin + 1e-4)
    {
      misses += trace.Cells.empty() ? 1 : 0;
      continue;
    }
    ++hits;
    ASSERT_EQ(trace.Cells.size(), 1u);
    const TracedCell& cell = trace.Cells[0];
    EXPECT_EQ(cell.Cell, 0u);
    EXPECT_EQ(cell.Outcome, CellOutcome::Gathered);
    EXPECT_NEAR((cell.Enter - trace.OriginDepth) * mesh.Frame.Radius, begin, tolerance);
    EXPECT_NEAR((cell.Leave - trace.OriginDepth) * mesh.Frame.Radius, end, tolerance);
    EXPECT_EQ(cell.ScalarEnter[0], scalar);
    EXPECT_EQ(cell.ScalarLeave[0], scalar);
    const double seen = slabOpacity(opacity / shot.UnitDistance, end - begin);
    EXPECT_NEAR(cell.Opacity, seen, 4.0 * tolerance);
    EXPECT_NEAR(cell.Color[0], seen, 4.0 * tolerance);
    EXPECT_NEAR(cell.Color[1], 0.5 * seen, 4.0 * tolerance);
    EXPECT_NEAR(cell.Color[2], 0.25 * seen, 4.0 * tolerance);
    EXPECT_NEAR(cell.Color[3], seen, 4.0 * tolerance);
  }
  EXPECT_GT(hits, 20);
  EXPECT_GT(misses, 20);
}

TEST(RayTraceAnalytic, OneTetrahedronInFloat) { expectUnitTet<float>(2e-6); }
TEST(RayTraceAnalytic, OneTetrahedronInDouble)
{
  expectUnitTet<double>(3e-7);
} // vertices are float

TEST(RayTraceAnalytic, CellsFollowEachOtherFromFaceToFace)
{
  Shot shot;
  shot.Data = latticeWithHole(6, 0.15, 1, sineField());
  const MarchedShot marched(shot, DefaultAccuracy);
  int joints = 0, entries = 0;
  for (int pixel = 0; pixel < Shot::Size * Shot::Size; pixel += 13)
  {
    const RayTrace trace =
      traceRay<double>(marched.Scene, DefaultAccuracy, pixel % Shot::Size, pixel / Shot::Size);
    for (std::size_t i = 1; i < trace.Cells.size(); ++i)
    {
      const TracedCell& before = trace.Cells[i - 1];
      const TracedCell& cell = trace.Cells[i];
      if (cell.EntersMesh)
      {
        EXPECT_GT(cell.Enter, before.Leave); // behind the hole
        ++entries;
      }
      else
      {
        EXPECT_EQ(cell.Enter, before.Leave);
        EXPECT_EQ(cell.ScalarEnter[0], before.ScalarLeave[0]);
        ++joints;
      }
    }
  }
  EXPECT_GT(joints, 500);
  EXPECT_GT(entries, 10);
}

TEST(RayTraceAnalytic, OpacitiesOfCellsMakeThatOfThePixel)
{
  Shot shot;
  const MarchedShot marched(shot, DefaultAccuracy);
  for (int pixel = 0; pixel < Shot::Size * Shot::Size; pixel += 13)
  {
    const RayTrace trace =
      traceRay<double>(marched.Scene, DefaultAccuracy, pixel % Shot::Size, pixel / Shot::Size);
    double transmittance = 1.0;
    for (const TracedCell& cell : trace.Cells)
    {
      transmittance *= 1.0 - cell.Opacity;
      EXPECT_NEAR(cell.Color[3], 1.0 - transmittance, 1e-12);
    }
    EXPECT_TRUE(!trace.Opaque || transmittance < DefaultAccuracy.ErrorTolerance);
  }
}

TEST(RayTraceAnalytic, ScalarsAreThoseOfTheData)
{
  Shot shot;
  shot.Data = jitteredLattice(
    4, 0.15, 1, [](double x, double y, double z) { return 100.0 + x + 2.0 * y + 3.0 * z; });
  shot.Optics = constantOptics(0.1);
  const MarchedShot marched(shot, DefaultAccuracy);
  int cells = 0;
  for (int pixel = 0; pixel < Shot::Size * Shot::Size; pixel += 13)
  {
    const RayTrace trace =
      traceRay<double>(marched.Scene, DefaultAccuracy, pixel % Shot::Size, pixel / Shot::Size);
    for (const TracedCell& cell : trace.Cells)
    {
      const Vec3 p = pointAt(marched.Mesh, trace, cell.Enter);
      EXPECT_NEAR(cell.ScalarEnter[0], 100.0 + p[0] + 2.0 * p[1] + 3.0 * p[2], 2e-6);
      ++cells;
    }
  }
  EXPECT_GT(cells, 300);
}
} // namespace
