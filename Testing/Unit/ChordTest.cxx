// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Meshes that are boxes, or boxes with boxes taken away: the length of every ray in them has a
// closed form.
#include "Reference/PointKernel.h"
#include "Reference/PortablePointKernel.h"

#include "ClosedForms.h"
#include "MarchedLength.h"
#include "RandomRays.h"
#include "UnitMeshes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

using Point = std::array<double, 3>;

template <typename Coordinate>
struct BoxOf
{
  double Sign; // +1: of the mesh, -1: taken away
  std::array<Coordinate, 3> Low, High;
};
using Box = BoxOf<double>;
using Boxes = std::vector<BoxOf<float>>;

// The same boxes in the normalised frame, rounded as the vertices are.
Boxes normalised(const std::vector<Box>& boxes, const TetMesh& mesh)
{
  Boxes rounded;
  for (const Box& box : boxes)
  {
    rounded.push_back({ box.Sign, {}, {} });
    for (int k = 0; k < 3; ++k)
    {
      rounded.back().Low[k] =
        static_cast<float>((box.Low[k] - mesh.Frame.Center[k]) / mesh.Frame.Radius);
      rounded.back().High[k] =
        static_cast<float>((box.High[k] - mesh.Frame.Center[k]) / mesh.Frame.Radius);
    }
  }
  return rounded;
}

// The chord of the mesh if all its faces stood `grown` further outwards.
double chord(const Boxes& boxes, const Point& o, const Point& d, double grown, double begin)
{
  double sum = 0.0;
  for (const auto& box : boxes)
  {
    Point low, high;
    for (int k = 0; k < 3; ++k)
    {
      low[k] = double(box.Low[k]) - box.Sign * grown;
      high[k] = double(box.High[k]) + box.Sign * grown;
    }
    const bool any = low[0] <= high[0] && low[1] <= high[1] && low[2] <= high[2];
    sum += any ? box.Sign * boxChord(o, d, low, high, begin) : 0.0;
  }
  return sum;
}

struct Tally
{
  double Worst = 0.0; // difference from the closed form, of rays not near a face
  int Near = 0;
};

// Rounding moves the projection of a vertex sideways: one difference, three products and their sum
// of numbers up to 2 make 8 eps, the basis 3 eps, interpolation of the crossing 4: below 16 eps. So
// the march may see the mesh grown or shrunk by that, for every ray whatever; its depth errs as
// much, and the sum of so many segments by eps each.
template <typename Kernel, typename Real>
void expectChords(const TetMesh& mesh, const Boxes& boxes, int rays, bool inside, Tally& tally)
{
  const double eps = double(std::numeric_limits<Real>::epsilon()) / 2;
  LengthMarcher<Kernel, Real> marcher(mesh);
  RandomRays random(31);
  for (int i = 0; i < rays; ++i)
  {
    const auto ray = random.next<Kernel, Real>(marcher.March, mesh);
    const Point o{ double(ray.origin.x), double(ray.origin.y), double(ray.origin.z) };
    const Point d{ double(ray.direction.x), double(ray.direction.y), double(ray.direction.z) };
    const Real begin = inside ? Real(random.uniformBetween(-0.9, 0.9)) : Real(-1e30f);
    const Marched marched = marcher.march(ray, begin);
    ASSERT_EQ(marched.Lost + marched.Refused + marched.Guarded, 0);
    const double sum = (32 + 2 * marched.Cells) * eps;
    const double least = chord(boxes, o, d, -16 * eps, double(begin));
    const double most = chord(boxes, o, d, 16 * eps, double(begin));
    ASSERT_GE(marched.Length, least - sum) << i;
    ASSERT_LE(marched.Length, most + sum) << i;
    if (most - least < 256 * eps)
    {
      const double exact = chord(boxes, o, d, 0.0, double(begin));
      tally.Worst = std::max(tally.Worst, std::abs(marched.Length - exact) / eps);
      ++tally.Near;
    }
  }
}

void expectChordsOf(const char* name, vtkUnstructuredGrid* grid, const std::vector<Box>& world)
{
  SCOPED_TRACE(name);
  const TetMesh mesh = builtWithHierarchy(grid);
  const Boxes boxes = normalised(world, mesh);
  Tally single, twice, portable;
  for (const bool inside : { false, true })
  {
    expectChords<PointKernel<float>, float>(mesh, boxes, 12000, inside, single);
    expectChords<PointKernel<double>, double>(mesh, boxes, 12000, inside, twice);
    expectChords<PortablePointKernel<float>, float>(mesh, boxes, 12000, inside, portable);
  }
  EXPECT_GT(single.Near, 6000);
  ::testing::Test::RecordProperty(name, std::to_string(single.Worst) + " " +
                                          std::to_string(twice.Worst) + " " +
                                          std::to_string(portable.Worst));
}

const Box Cube{ 1.0, { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 } };

TEST(Chord, OfConvexMeshes)
{
  expectChordsOf("plain", jitteredLattice(4, 0.0), { Cube });
  expectChordsOf("jittered", jitteredLattice(6), { Cube });
  expectChordsOf("fine", jitteredLattice(16), { Cube });
  expectChordsOf("shuffled", shuffled(jitteredLattice(5)), { Cube });
  expectChordsOf("mixed", mixedCells(4, 1, 0.1), { Cube });
  expectChordsOf("quadratic", quadraticHexLattice(2, 0.1), { Cube });
  expectChordsOf("far", withOffsetAndScale(jitteredLattice(4), { 1e6, -2e6, 3e6 }, 0.25),
    { { 1.0, { 1e6, -2e6, 3e6 }, { 1e6 + 0.25, -2e6 + 0.25, 3e6 + 0.25 } } });
}

TEST(Chord, OfNonConvexMeshes)
{
  const double b = holeBegin(6) / 6.0;
  const double e = holeEnd(6) / 6.0;
  expectChordsOf("hole", latticeWithHole(6), { Cube, { -1.0, { b, b, b }, { e, e, e } } });
  expectChordsOf("tunnel", latticeWithTunnel(6), { Cube, { -1.0, { b, b, 0 }, { e, e, 1 } } });
  expectChordsOf("L", lShape(4), { Cube, { -1.0, { 0.5, 0.5, 0 }, { 1, 1, 1 } } });
  expectChordsOf("two components", twoComponents(4),
    { Cube, { 1.0, { 1.25, 0.25, 0.25 }, { 1.75, 0.75, 0.75 } } });
}

// Points moved so far that tetrahedra turn over and overlap: nothing is integrated twice or left
// out.
TEST(Chord, OfTangledMeshes)
{
  expectChordsOf("tangled", jitteredLattice(4, 0.45), { Cube });
  expectChordsOf("overlapping", joined(jitteredLattice(3), jitteredLattice(2)), { Cube });
}

// The integral of a linear field is its value in the middle of the chord times the length; begin
// and end inside a cell need its scalar there. The table's integrals are 32-bit fixed-point numbers
// of at most 2^10 bins: half a unit over an interval of a bin or more is 1.2e-7 of a mean.
template <typename Kernel, typename Real>
void expectLinearField(vtkUnstructuredGrid* grid, int rays)
{
  TetMesh mesh = builtWithHierarchy(grid);
  const Boxes boxes = normalised({ Cube }, mesh);
  const auto field = [](double x, double y, double z)
  { return 0.5 + 0.3 * x - 0.25 * y + 0.15 * z; };
  for (Vertex& v : mesh.Vertices)
  {
    v.Scalar = static_cast<float>(field(double(v.X), double(v.Y), double(v.Z)));
  }
  const IntegralTable ramp = tableOf(
    [](double f) {
      return std::array<double, 4>{ { f, 1.0, 1.0, 1.0 } };
    });
  LengthMarcher<Kernel, Real> lengths(mesh);
  LengthMarcher<Kernel, Real> marcher(mesh, ramp);
  RandomRays random(32);
  const double eps = double(std::numeric_limits<Real>::epsilon()) / 2;
  int compared = 0;
  for (int i = 0; i < rays; ++i)
  {
    const auto ray = random.next<Kernel, Real>(marcher.March, mesh);
    const Point o{ double(ray.origin.x), double(ray.origin.y), double(ray.origin.z) };
    const Point d{ double(ray.direction.x), double(ray.direction.y), double(ray.direction.z) };
    const double begin = double(Real(random.uniformBetween(-1.2, 0.5)));
    const double spread =
      chord(boxes, o, d, 16 * eps, begin) - chord(boxes, o, d, -16 * eps, begin);
    const double length = chord(boxes, o, d, 0.0, begin);
    if (spread > 256 * eps || length == 0.0)
    {
      continue;
    }
    double far = 1e30;
    for (int k = 0; k < 3; ++k)
    {
      if (d[k] != 0.0)
      {
        far =
          std::min(far, (double(d[k] > 0.0 ? boxes[0].High[k] : boxes[0].Low[k]) - o[k]) / d[k]);
      }
    }
    const double middle = far - 0.5 * length;
    const double expected =
      length * field(o[0] + middle * d[0], o[1] + middle * d[1], o[2] + middle * d[2]);
    const Marched marched = marcher.march(ray, Real(begin));
    // Scalars are rounded to float (2^-25 each), and interpolated with the weights' 16 eps.
    const double bound =
      spread + (64 + 2 * marched.Cells) * eps + (1.2e-7 + std::ldexp(1.0, -24)) * length;
    ASSERT_NEAR(marched.Length, expected, bound) << i;
    ++compared;
  }
  EXPECT_GT(compared, rays / 4);
}

TEST(Chord, LinearFieldsAreIntegratedExactly)
{
  expectLinearField<PointKernel<double>, double>(jitteredLattice(5), 20000);
  expectLinearField<PointKernel<float>, float>(jitteredLattice(5), 20000);
  expectLinearField<PortablePointKernel<float>, float>(jitteredLattice(5), 20000);
  // Also where tetrahedra are turned over.
  expectLinearField<PointKernel<double>, double>(jitteredLattice(4, 0.45), 20000);
  expectLinearField<PointKernel<float>, float>(jitteredLattice(4, 0.45), 20000);
}
} // namespace
