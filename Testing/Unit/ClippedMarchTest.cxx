// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The march through a volume that is cut: lengths in closed form, pictures against the ground
// truth.
#include "Mesh/MeshScalars.h"
#include "Reference/PointKernel.h"

#include "ClosedForms.h"
#include "CutLine.h"
#include "RandomRays.h"
#include "Shot.h"
#include "UnitMeshes.h"

#include "vtkPointData.h"
#include "vtkVolume.h"

#include <cmath>
#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;
using Point = std::array<double, 3>;

void addPlane(vtkPlaneCollection* planes, const Point& origin, const Point& normal)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(origin[0], origin[1], origin[2]);
  plane->SetNormal(normal[0], normal[1], normal[2]);
  planes->AddItem(plane);
}

// Constant extinction in a cube: the transmittance of what is left of a ray is known.
template <typename Real>
class CutCube
{
public:
  static constexpr double Thickness = 1.5; // optical, of the cube's side

  CutCube()
  {
    readScalars(this->Data, { this->Data->GetPointData()->GetScalars() }, this->Mesh);
    this->March = kernelOf<PointKernel<Real>, Real>(this->Mesh, this->Table, GroundTruthAccuracy);
  }

  // The greatest error of the transmittance of many rays.
  double errorOf(const ClippingOptions& options)
  {
    Clipping clipping;
    EXPECT_EQ(makeClipping(options, this->Volume, this->Mesh.Frame, clipping), "");
    this->March.useClipping(clipping);
    double most = 0.0;
    for (int i = 0; i < 300; ++i)
    {
      const auto ray = this->Random.template next<PointKernel<Real>, Real>(this->March, this->Mesh);
      const Point o = this->dataOf(ray.origin, this->Mesh.Frame.Center);
      const Point d = this->dataOf(ray.direction, { 0.0, 0.0, 0.0 });
      Point ends[2];
      if (this->crossesInside(o, d, ends))
      {
        const auto range = this->March.clippedRange(ray, { Real(-3e38f), Real(3e38f) });
        const auto march = this->March.castPlainRay(
          ray, Real(Thickness * this->Mesh.Frame.Radius), range.x, range.y);
        const double length =
          std::hypot(ends[1][0] - ends[0][0], ends[1][1] - ends[0][1], ends[1][2] - ends[0][2]) *
          fractionLeft(options, { ends[0], ends[0] }, { ends[1], ends[1] });
        most = std::max(
          most, std::abs(double(march.radiance.transmittance) - std::exp(-Thickness * length)));
        this->Longest = std::max(this->Longest, length);
        ++this->Rays;
      }
    }
    return most;
  }

  RandomRays Random{ 17 };
  Grid Data = jitteredLattice(5, 0.15, 1, constantField(0.5));
  TetMesh Mesh = builtWithHierarchy(Data);
  IntegralTable Table = whiteTable();
  vtkNew<vtkVolume> Volume;
  PointKernel<Real> March;
  int Rays = 0;
  double Longest = 0.0;

private:
  Point dataOf(const glsl::Vec3<Real>& v, const Point& offset) const
  {
    const double r = this->Mesh.Frame.Radius;
    return { offset[0] + r * double(v.x), offset[1] + r * double(v.y),
      offset[2] + r * double(v.z) };
  }

  // Where it enters and leaves the cube; not of rays that graze it.
  static bool crossesInside(const Point& o, const Point& d, Point (&ends)[2])
  {
    double t0 = -10.0, t1 = 10.0;
    for (int k = 0; k < 3; ++k)
    {
      const double a = -o[k] / d[k], b = (1.0 - o[k]) / d[k];
      if (std::abs(d[k]) < 1e-12)
      {
        t1 = o[k] > 1e-3 && o[k] < 0.999 ? t1 : t0;
        continue;
      }
      t0 = std::max(t0, std::min(a, b));
      t1 = std::min(t1, std::max(a, b));
    }
    for (int k = 0; k < 3; ++k)
    {
      ends[0][k] = o[k] + t0 * d[k];
      ends[1][k] = o[k] + t1 * d[k];
    }
    const Point middle = mixed(ends[0], ends[1], 0.5);
    return t1 > t0 && boxChord(middle, d, { 1e-3, 1e-3, 1e-3 }, { 0.999, 0.999, 0.999 }) > 0.0;
  }
};

template <typename Real>
void expectLengths(const ClippingOptions& options, const std::string& what, double bound)
{
  CutCube<Real> cube;
  EXPECT_LE(cube.errorOf(options), bound) << what;
  EXPECT_GT(cube.Rays, 100) << what;
}

// Positions are floats, as in AnalyticTest; planes, in float, too.
constexpr double DoubleBound = 4e-7;
constexpr double FloatBound = 1e-5;

TEST(ClippedMarch, PlanesInClosedForm)
{
  vtkNew<vtkPlaneCollection> planes;
  ClippingOptions options;
  options.Planes = planes;
  addPlane(planes, { 0.47, 0.52, 0.55 }, { 0.3, -1.0, 0.6 });
  expectLengths<double>(options, "one", DoubleBound);
  expectLengths<float>(options, "one", FloatBound);
  addPlane(planes, { 0.31, 0.0, 0.0 }, { 2.0, 0.0, 0.0 }); // parallel to some rays
  addPlane(planes, { 0.5, 0.83, 0.5 }, { -0.2, -1.0, -0.1 });
  expectLengths<double>(options, "three", DoubleBound);
  expectLengths<float>(options, "three", FloatBound);
}

TEST(ClippedMarch, PlanesThatLeaveNothing)
{
  vtkNew<vtkPlaneCollection> planes;
  ClippingOptions options;
  options.Planes = planes;
  addPlane(planes, { 0.5, 0.5, 0.5 }, { 0.1, 1.0, 0.2 });
  addPlane(planes, { 0.5, 0.49, 0.5 }, { -0.1, -1.0, -0.2 });
  CutCube<float> cube;
  EXPECT_EQ(cube.errorOf(options), 0.0);
  EXPECT_EQ(cube.Longest, 0.0);
}

TEST(ClippedMarch, CroppingInClosedForm)
{
  ClippingOptions options;
  options.Cropping = true;
  options.CroppingPlanes = { { 0.237, 0.711, 0.313, 0.564, 0.159, 0.823 } };
  for (const int flags : croppingFlagsToTest())
  {
    options.CroppingFlags = flags;
    const std::string what = std::to_string(flags);
    expectLengths<double>(options, what, DoubleBound);
    expectLengths<float>(options, what, FloatBound);
  }
}

// All six planes within one cell, and very near to each other.
TEST(ClippedMarch, NarrowRegionsInClosedForm)
{
  ClippingOptions options;
  options.Cropping = true;
  for (const double width : { 0.05, 1e-3 })
  {
    options.CroppingPlanes = { { 0.43, 0.43 + width, 0.51, 0.51 + width, 0.47, 0.47 + width } };
    for (const int flags : { 0x2ebfeba, 0x5140145, 0x0417410, 0x7be8bef })
    {
      options.CroppingFlags = flags;
      expectLengths<double>(options, std::to_string(flags), DoubleBound);
      expectLengths<float>(options, std::to_string(flags), FloatBound);
    }
  }
}

// Without cuts the march of the clipped variant is the same to the last bit.
TEST(ClippedMarch, WhatCutsNothingChangesNoBit)
{
  CutCube<float> plain, cube;
  ClippingOptions options;
  options.Cropping = true;
  options.CroppingPlanes = { { -3.0, 4.0, -5.0, 6.0, -7.0, 8.0 } };
  options.CroppingFlags = 0x2002000; // no box; the other region is empty
  Clipping clipping;
  ASSERT_EQ(makeClipping(options, cube.Volume, cube.Mesh.Frame, clipping), "");
  ASSERT_TRUE(clipping.Cropped);
  cube.March.useClipping(clipping);
  for (int i = 0; i < 300; ++i)
  {
    const auto ray = plain.Random.next<PointKernel<float>, float>(plain.March, plain.Mesh);
    const auto whole = plain.March.castPlainRay(ray, 1.0f, -3e38f, 3e38f);
    const auto same = cube.Random.next<PointKernel<float>, float>(cube.March, cube.Mesh);
    const auto range = cube.March.clippedRange(same, { -3e38f, 3e38f });
    const auto cut = cube.March.castPlainRay(same, 1.0f, range.x, range.y);
    ASSERT_EQ(whole.radiance.transmittance, cut.radiance.transmittance);
    ASSERT_EQ(whole.radiance.color.x, cut.radiance.color.x);
    ASSERT_EQ(whole.cells, cut.cells);
    ASSERT_EQ(whole.lookups, cut.lookups);
  }
}

class CutShot : public ::testing::TestWithParam<ScalarsOf>
{
protected:
  CutShot()
  {
    this->Taken.Scalars = this->GetParam();
    this->Taken.Transform->Translate(0.1, 0.05, 0.0);
    this->Taken.Transform->RotateWXYZ(30.0, 1.0, 2.0, 3.0);
    this->Taken.Transform->Scale(1.0, 0.7, -0.8);
    this->Taken.Cut.Planes = this->Planes;
  }

  // With colours and scalars that change within cells.
  void expectGroundTruth()
  {
    const Image right = byGroundTruth(this->Taken);
    for (const AccuracyLevel& level : { DefaultAccuracy, GroundTruthAccuracy })
    {
      const double tolerance = level.ErrorTolerance;
      MarchCounters counters;
      const Difference inDouble = compare(byReference<double>(this->Taken, level, counters), right);
      EXPECT_LE(inDouble.Max, tolerance + 2e-5) << inDouble.text();
      EXPECT_GT(counters.Rays, 50);
      EXPECT_EQ(counters.Lost + counters.Guarded, 0);
      const Difference inFloat = compare(byReference<float>(this->Taken, level, counters), right);
      EXPECT_LE(inFloat.Max, tolerance + 2e-4) << inFloat.text();
      std::cout << "[ MEASURED ] " << inDouble.text() << "; float " << inFloat.text() << '\n';
    }
  }

  Shot Taken;
  vtkNew<vtkPlaneCollection> Planes;
};

TEST_P(CutShot, ByPlanes)
{
  addPlane(this->Planes, { 0.5, 0.4, 0.4 }, { 0.4, -0.3, -1.0 });
  this->expectGroundTruth();
  addPlane(this->Planes, { 0.5, 0.45, 0.4 }, { 0.1, 1.0, 0.3 });
  this->expectGroundTruth();
}

TEST_P(CutShot, ByPlanesInParallelProjection)
{
  addPlane(this->Planes, { 0.5, 0.4, 0.4 }, { 0.4, -0.3, -1.0 });
  this->Taken.Camera->ParallelProjectionOn();
  this->Taken.Camera->SetParallelScale(0.8);
  this->expectGroundTruth();
}

TEST_P(CutShot, ByCropping)
{
  this->Taken.Cut.Cropping = true;
  this->Taken.Cut.CroppingPlanes = { { 0.237, 0.711, 0.313, 0.564, 0.159, 0.823 } };
  for (const int flags : { 0x2ebfeba, 0x5140145, 0x0417410, 0x7be8bef, 0x0002000 })
  {
    this->Taken.Cut.CroppingFlags = flags;
    this->expectGroundTruth();
  }
}

TEST_P(CutShot, ByBothInAMeshOfSeveralParts)
{
  this->Taken.Data = nestedShells(6, 3, 0.15, 1, sineField());
  addPlane(this->Planes, { 0.5, 0.4, 0.4 }, { 0.4, -0.3, -1.0 });
  this->Taken.Cut.Cropping = true;
  this->Taken.Cut.CroppingPlanes = { { 0.337, 0.611, 0.313, 0.564, 0.259, 0.723 } };
  this->Taken.Cut.CroppingFlags = 0x7be8bef;
  this->expectGroundTruth();
}

TEST_P(CutShot, WithOpaqueGeometry)
{
  addPlane(this->Planes, { 0.5, 0.4, 0.4 }, { 0.4, -0.3, -1.0 });
  this->Taken.Depths.assign(Shot::Size * Shot::Size, 1.0f);
  for (int i = 0; i < Shot::Size * Shot::Size; i += 3)
  {
    this->Taken.Depths[i] = 0.97f + 0.02f * static_cast<float>(i % 7) / 7.0f;
  }
  this->expectGroundTruth();
}

INSTANTIATE_TEST_SUITE_P(Scalars, CutShot, ::testing::Values(ScalarsOf::Points, ScalarsOf::Cells));
} // namespace
