// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Tetrahedra that are turned inside out, or flat: rays see the union of the cells all the same.
#include "Mesh/ConsistentOrientation.h"
#include "Mesh/Orientation.h"
#include "Reference/PointKernel.h"

#include "ClosedForms.h"
#include "GroundTruth.h"
#include "MarchedLength.h"
#include "RandomRays.h"
#include "UnitMeshes.h"

#include "vtkCellType.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;
using Point = std::array<double, 3>;

// Every third point of the side x = 1 pushed behind the next layers.
Grid dentedThroughItself()
{
  const Grid grid = jitteredLattice(4, 0.1);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); i += 3)
  {
    double p[3];
    grid->GetPoint(i, p);
    grid->GetPoints()->SetPoint(i, p[0] > 0.99 ? p[0] - 0.4 : p[0], p[1], p[2]);
  }
  return grid;
}

void expectUnionOfCells(const TetMesh& mesh)
{
  LengthMarcher<PointKernel<double>, double> marcher(mesh);
  const GroundTruthScene groundTruth(asGrid(mesh), constantModel());
  RandomRays random(31);
  for (int i = 0; i < 4000; ++i)
  {
    const auto ray = random.next<PointKernel<double>, double>(marcher.March, mesh);
    if (random.LastKind != RandomRays::Kind::Generic)
    {
      continue;
    }
    const Point o{ ray.origin.x, ray.origin.y, ray.origin.z };
    const Point d{ ray.direction.x, ray.direction.y, ray.direction.z };
    ASSERT_NEAR(marcher.march(ray).Length, groundTruth.pathLength(o, d), 1e-10) << i;
  }
}

TEST(TangledMeshes, RaysSeeTheUnionOfTheCells)
{
  const TetMesh inside = builtWithHierarchy(jitteredLattice(4, 0.6));
  const TetMesh everywhere = builtWithHierarchy(jitteredLattice(4, 1.5));
  const TetMesh outside = builtWithHierarchy(dentedThroughItself());
  EXPECT_GT(inside.Report.FoldedFaces, 0);
  EXPECT_GT(everywhere.Report.FoldedFaces, inside.Report.FoldedFaces);
  EXPECT_GT(outside.Report.FoldedFaces, 0);
  expectUnionOfCells(inside);
  expectUnionOfCells(everywhere);
  expectUnionOfCells(outside);
  EXPECT_NE(describe(outside.Report).find("inside out"), std::string::npos);
}

TEST(TangledMeshes, SoundMeshesHaveNoFolds)
{
  for (const NamedGrid& named : everyGrid())
  {
    SCOPED_TRACE(named.Name);
    const TetMesh mesh = built(named.Make());
    EXPECT_EQ(mesh.Report.FoldedFaces, 0);
  }
}

// The tetrahedron behind a link lies on the other side of the face, so that no ray turns back.
TEST(TangledMeshes, LinksLeadForwards)
{
  const TetMesh mesh = built(jitteredLattice(5, 1.0));
  for (Id h = 0; h < 4 * mesh.numberOfTets(); ++h)
  {
    const Id link = mesh.Links[h];
    if (link < LinkOutside)
    {
      ASSERT_LE(inwardSide(mesh, h) * inwardSide(mesh, link), 0) << h;
    }
  }
}

// A layer of flat tetrahedra between two that lie on the same side of it can't join them.
TEST(TangledMeshes, FlatTetsDontJoinWhatOverlaps)
{
  GridBuilder builder;
  for (const Point& p : std::vector<Point>{
         { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0.3, 0.3, 1 }, { 0.6, 0.6, 0.8 } })
  {
    builder.addPoint(p);
  }
  // The flat one has the square as its faces from above (0 1 2, 0 2 3) and from below (0 1 3, 1 2
  // 3).
  builder.addCell(VTK_TETRA, { 0, 1, 2, 3 });
  builder.addCell(VTK_TETRA, { 0, 1, 2, 4 });
  builder.addCell(VTK_TETRA, { 1, 2, 3, 5 }); // above, too
  const TetMesh mesh = builtWithHierarchy(builder.finish(linearField()));
  EXPECT_EQ(mesh.Report.FoldedFaces, 1);
  expectUnionOfCells(mesh);
}

// Rays down edges and in faces: what they gather of a linear field is exact, length times the field
// in the middle of the chord.
TEST(TangledMeshes, RaysInFacesSeeTheFieldWhereTheyAre)
{
  TetMesh mesh = builtWithHierarchy(jitteredLattice(4, 0.0));
  const auto field = [](double x, double y, double z) { return 0.5 + 0.2 * x - 0.3 * y + 0.1 * z; };
  for (Vertex& v : mesh.Vertices)
  {
    v.Scalar = static_cast<float>(field(double(v.X), double(v.Y), double(v.Z)));
  }
  // Colour is the scalar, extinction 1: with next to no extinction the sum of scalar times length.
  const IntegralTable ramp = tableOf(
    [](double s) {
      return std::array<double, 4>{ { s, s, s, 1.0 } };
    });
  LengthMarcher<PointKernel<double>, double> weighted(mesh, ramp), plain(mesh);
  const double h = mesh.Frame.HalfExtent[0];
  RandomRays random(33);
  int compared = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const auto ray = random.next<PointKernel<double>, double>(plain.March, mesh);
    const Point o{ ray.origin.x, ray.origin.y, ray.origin.z };
    const Point d{ ray.direction.x, ray.direction.y, ray.direction.z };
    // Rays on the surface may see it or not.
    const double length = boxChord(o, d, { -h, -h, -h }, { h, h, h });
    const double smaller =
      boxChord(o, d, { 1e-6 - h, 1e-6 - h, 1e-6 - h }, { h - 1e-6, h - 1e-6, h - 1e-6 });
    if (smaller < length - 1e-4 || length == 0.0)
    {
      continue;
    }
    double begin = -1e9;
    for (int k = 0; k < 3; ++k)
    {
      begin = std::max(begin, d[k] == 0.0 ? begin : (-std::copysign(h, d[k]) - o[k]) / d[k]);
    }
    const double t = begin + 0.5 * length;
    const double expected = length * field(o[0] + t * d[0], o[1] + t * d[1], o[2] + t * d[2]);
    ASSERT_NEAR(plain.march(ray).Length, length, 1e-5) << i; // the box is rounded
    ASSERT_NEAR(weighted.march(ray).Length, expected, 1e-5) << i;
    compared += random.LastKind != RandomRays::Kind::Generic;
  }
  EXPECT_GT(compared, 5000);
}
} // namespace
