// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The march through structured volumes against the ground truth.
#include "Reference/ConstantKernel.h"
#include "Reference/FastTrilinearKernel.h"
#include "Reference/TrilinearKernel.h"

#include "StructuredRays.h"

#include "Fields.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

const LatticeValues AllValues[] = { LatticeValues::PointsLinear, LatticeValues::PointsNearest,
  LatticeValues::CellsLinear, LatticeValues::CellsNearest };

Field noise(unsigned seed)
{
  return [seed](double x, double y, double z)
  {
    const double s = std::sin(12.9898 * x + 78.233 * y + 37.719 * z + seed) * 43758.5453;
    return s - std::floor(s);
  };
}

struct Errors
{
  double Most = 0;      // of a channel
  double OverBound = 0; // beyond the bound of the march
  long Rays = 0;
  long Lost = 0;
};

template <typename Kernel, typename Real>
Errors errorsOf(const StructuredRays& rays, int count, unsigned seed)
{
  auto kernel = rays.kernel<Kernel, Real>();
  std::mt19937 random(seed);
  Errors errors;
  for (int i = 0; i < count; ++i)
  {
    const tetmarch::testing::Vec3 point = rays.pointNear(random, 1.1);
    const tetmarch::testing::Vec3 d = StructuredRays::direction(random);
    const double begin = i % 3 ? -4.0 : 0.1 * StructuredRays::share(random);
    const auto ray = kernel.rayThrough(
      { Real(point[0]), Real(point[1]), Real(point[2]) }, { Real(d[0]), Real(d[1]), Real(d[2]) });
    const double offset = point[0] * d[0] + point[1] * d[1] + point[2] * d[2];
    const auto march =
      kernel.castPlainRay(ray, Real(rays.PerDepth), Real(begin + offset), Real(4.0 + offset));
    const Rgba truth = rays.truth(point, d, begin, 4.0);
    const Rgba found{ { double(march.radiance.color.x), double(march.radiance.color.y),
      double(march.radiance.color.z), 1.0 - double(march.radiance.transmittance) } };
    double most = 0;
    for (int k = 0; k < 4; ++k)
    {
      most = std::max(most, std::abs(found[k] - truth[k]));
      EXPECT_TRUE(std::isfinite(found[k]));
    }
    errors.Most = std::max(errors.Most, most);
    errors.OverBound = std::max(errors.OverBound, most - double(kernel.errorBound(march.radiance)));
    errors.Lost += march.lost + march.guarded;
    ++errors.Rays;
  }
  return errors;
}

template <typename Real>
Errors errorsOf(const StructuredRays& rays, int count, unsigned seed)
{
  return rays.Cells.Constant ? errorsOf<ConstantKernel<Real>, Real>(rays, count, seed)
                             : errorsOf<TrilinearKernel<Real>, Real>(rays, count, seed);
}

TEST(StructuredMarch, IsTheGroundTruthWhereverImagesAre)
{
  for (const ImagePlace& place : imagePlaces())
  {
    const auto image = imageOf(noise(1), place);
    const double length = image->GetLength();
    for (const LatticeValues values : AllValues)
    {
      SCOPED_TRACE(std::string(place.Name) + ", values " + std::to_string(int(values)));
      const StructuredRays rays(image, values, rampAndPeak(0.1 * length));
      const Errors exact = errorsOf<double>(rays, 200, 3);
      EXPECT_LT(exact.Most, 2e-6);
      EXPECT_EQ(exact.Lost, 0);
      const Errors single = errorsOf<float>(rays, 200, 4);
      EXPECT_LT(single.Most, 1e-5);
      EXPECT_EQ(single.Lost, 0);
    }
  }
}

TEST(StructuredMarch, KeepsItsTolerance)
{
  for (const double tolerance : { 1.0 / 255, 1.0 / 1024 })
  {
    const AccuracyLevel level = levelOf(Accuracy::Default, tolerance);
    for (const double unit : { 0.02, 0.1, 0.5 })
    {
      const StructuredRays rays(
        imageOf(noise(2), unitCube(6)), LatticeValues::PointsLinear, rampAndPeak(unit), level);
      const Errors found = errorsOf<double>(rays, 1000, 5);
      EXPECT_LT(found.Most, tolerance) << unit;
      EXPECT_EQ(found.OverBound, 0);
      std::cout << "[ MEASURED ] unit " << unit << ": " << found.Most / tolerance
                << " of the tolerance\n";
    }
  }
}

// Nothing but the bound is promised.
TEST(StructuredMarch, EvenCutsKeepTheirBound)
{
  const AccuracyLevel level = levelOf(Accuracy::Fast, 1.0);
  for (const double unit : { 0.02, 0.1, 0.5 })
  {
    const StructuredRays rays(
      imageOf(noise(6), unitCube(6)), LatticeValues::PointsLinear, rampAndPeak(unit), level);
    const Errors found = errorsOf<FastTrilinearKernel<double>, double>(rays, 2000, 7);
    EXPECT_EQ(found.OverBound, 0) << unit;
    EXPECT_EQ(found.Lost, 0);
    std::cout << "[ MEASURED ] unit " << unit << ": " << 255 * found.Most << " of 255\n";
  }
}

// A field that is linear needs no cuts; where cells are thin, only the table's bins are lost.
TEST(StructuredMarch, EvenCutsLoseLittleInALinearField)
{
  const AccuracyLevel level = levelOf(Accuracy::Fast, 1.0);
  const Field linear = [](double x, double y, double z) { return 0.5 * x + 0.3 * y + 0.2 * z; };
  const StructuredRays rays(
    imageOf(linear, unitCube(6)), LatticeValues::PointsLinear, rampAndPeak(40), level);
  const Errors found = errorsOf<FastTrilinearKernel<double>, double>(rays, 1000, 8);
  // Half of what the extinction rises in a bin of the peak, along the longest ray.
  const double risePerBin = -std::log(1 - 0.9) / 20;
  EXPECT_LT(found.Most, 0.5 * risePerBin * std::sqrt(3.0) / 40);
}
} // namespace
