// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// No ray is lost, and the length that it marches is that of the geometry.
#include "Reference/PointKernel.h"
#include "Reference/PortablePointKernel.h"

#include "GroundTruth.h"
#include "MarchedLength.h"
#include "RandomRays.h"
#include "UnitMeshes.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkPoints.h"

#include <cmath>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

using Point = std::array<double, 3>;

// Every kind of ray through every grid.
template <typename Kernel, typename Real>
void expectNothingLost(const TetMesh& mesh, int rays)
{
  LengthMarcher<Kernel, Real> marcher(mesh);
  RandomRays random(21);
  int met = 0;
  for (int i = 0; i < rays; ++i)
  {
    const auto ray = random.next<Kernel, Real>(marcher.March, mesh);
    const Marched marched = marcher.march(ray);
    ASSERT_EQ(marched.Lost, 0) << i;
    ASSERT_EQ(marched.Refused, 0) << i;
    ASSERT_EQ(marched.Guarded, 0) << i;
    ASSERT_TRUE(marched.Length >= 0.0 && marched.Length <= 2.0 + 1e-5) << i;
    met += marched.Cells > 0;
  }
  EXPECT_GT(met, rays / 4);
}

TEST(Traversal, NoRayIsLost)
{
  // 31 grids, 651,000 rays.
  for (const NamedGrid& named : everyGrid())
  {
    SCOPED_TRACE(named.Name);
    const TetMesh mesh = builtWithHierarchy(named.Make());
    expectNothingLost<PointKernel<float>, float>(mesh, 8000);
    expectNothingLost<PointKernel<double>, double>(mesh, 5000);
    expectNothingLost<PortablePointKernel<float>, float>(mesh, 8000);
  }
}

TEST(Traversal, NoRayIsLostInTangledAndFlatMeshes)
{
  const auto check = [](vtkUnstructuredGrid* grid)
  {
    const TetMesh mesh = builtWithHierarchy(grid);
    expectNothingLost<PointKernel<float>, float>(mesh, 20000);
    expectNothingLost<PointKernel<double>, double>(mesh, 20000);
    expectNothingLost<PortablePointKernel<float>, float>(mesh, 20000);
  };
  check(jitteredLattice(4, 0.6));
  // Points moved onto each other: many flat tetrahedra and slivers.
  for (const double step : { 0.5, 0.02 })
  {
    const Grid snapped = jitteredLattice(5, 0.45, 3);
    for (vtkIdType i = 0; i < snapped->GetNumberOfPoints(); ++i)
    {
      double p[3];
      snapped->GetPoint(i, p);
      snapped->GetPoints()->SetPoint(
        i, step * std::round(p[0] / step), p[1], step * std::round(p[2] / step));
    }
    check(snapped);
  }
}

// Against the ground truth on the very floats of the mesh. A ray that grazes a boundary at an angle
// a moves its ends by eps / a; of some thousand rays the flattest makes about 1e-4.
TEST(Traversal, LengthsAreThoseOfTheGroundTruth)
{
  double worst = 0.0;
  for (const NamedGrid& named : everyGrid())
  {
    SCOPED_TRACE(named.Name);
    const TetMesh mesh = builtWithHierarchy(named.Make());
    LengthMarcher<PointKernel<double>, double> marcher(mesh);
    const GroundTruthScene groundTruth(asGrid(mesh), constantModel());
    RandomRays random(22);
    const bool squashed = named.Name == std::string("squashed lattice");
    for (int i = 0; i < 3000; ++i)
    {
      const auto ray = random.next<PointKernel<double>, double>(marcher.March, mesh);
      if (random.LastKind != RandomRays::Kind::Generic)
      {
        continue;
      }
      const Point o{ ray.origin.x, ray.origin.y, ray.origin.z };
      const Point d{ ray.direction.x, ray.direction.y, ray.direction.z };
      const double error = std::abs(marcher.march(ray).Length - groundTruth.pathLength(o, d));
      ASSERT_LE(error, squashed ? 1e-8 : 1e-11) << i;
      worst = std::max(worst, error);
      // Camera and opaque geometry inside.
      const double begin = random.uniformBetween(-1.0, 1.0);
      const double end = random.uniformBetween(begin, 1.2);
      ASSERT_NEAR(
        marcher.march(ray, begin, end).Length, groundTruth.pathLength(o, d, begin, end), 1e-8);
    }
  }
  RecordProperty("worst", std::to_string(worst));
}

TEST(Traversal, CutsAddUp)
{
  const TetMesh mesh = builtWithHierarchy(latticeWithTunnel(6));
  LengthMarcher<PointKernel<float>, float> marcher(mesh);
  RandomRays random(24);
  const double eps = std::ldexp(1.0, -24);
  for (int i = 0; i < 20000; ++i)
  {
    const auto ray = random.next<PointKernel<float>, float>(marcher.March, mesh);
    const auto cut = static_cast<float>(random.uniformBetween(-1.0, 1.0));
    const Marched whole = marcher.march(ray);
    const double parts =
      marcher.march(ray, -3e38f, cut).Length + marcher.march(ray, cut, 3e38f).Length;
    // Rounding of sums of so many segments of together at most 2.
    ASSERT_NEAR(whole.Length, parts, 2 * eps * (whole.Cells + 8));
  }
}

Grid split(vtkUnstructuredGrid* grid)
{
  GridBuilder builder;
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    Point p;
    grid->GetPoint(i, p.data());
    builder.addPoint(p);
  }
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    vtkIdType count;
    const vtkIdType* ids;
    grid->GetCells()->GetCellAtId(c, count, ids);
    const vtkIdType middle = builder.between({ ids[0], ids[1], ids[2], ids[3] });
    for (int i = 0; i < 4; ++i)
    {
      Ids part(ids, ids + 4);
      part[i] = middle;
      builder.addCell(VTK_TETRA, part);
    }
  }
  return builder.finish(linearField());
}

TEST(Traversal, SplittingAndShufflingChangeNothing)
{
  for (const Grid& grid : { jitteredLattice(4), latticeWithHole(6), jitteredLattice(3, 0.0) })
  {
    const TetMesh mesh = builtWithHierarchy(grid);
    const TetMesh finer = builtWithHierarchy(split(grid));
    const TetMesh mixed = builtWithHierarchy(shuffled(grid, 9));
    EXPECT_EQ(finer.Tets.size(), 4 * mesh.Tets.size());
    LengthMarcher<PointKernel<double>, double> a(mesh), b(finer), c(mixed);
    RandomRays random(25);
    for (int i = 0; i < 10000; ++i)
    {
      const auto ray = random.next<PointKernel<double>, double>(a.March, mesh);
      const double length = a.march(ray).Length;
      if (random.LastKind == RandomRays::Kind::Generic)
      {
        ASSERT_NEAR(b.march(ray).Length, length, 1e-12);
        ASSERT_NEAR(c.march(ray).Length, length, 1e-12);
      }
      else
      {
        // On the surface other ids break the ties otherwise; nothing is lost though.
        ASSERT_EQ(b.march(ray).Lost + c.march(ray).Lost, 0);
      }
    }
  }
}
} // namespace
