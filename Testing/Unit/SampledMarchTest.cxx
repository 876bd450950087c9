// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Samples at even distances against brute force: the cells that a ray meets, the scalar in them and
// the functions are those of the ground truth, in double precision.
#include "StructuredRays.h"

#include "Rays/RaySamples.h"
#include "Reference/SampledConstantKernel.h"
#include "Reference/SampledTrilinearKernel.h"

#include <algorithm>
#include <iostream>
#include <limits>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

// Tables as fine as the ground truth has them, and rays that end when nothing is left.
constexpr AccuracyLevel FineSamples{ false, 1e-9, 1, 65536, 262144, true };

Field noise(unsigned seed)
{
  return [seed](double x, double y, double z)
  {
    const double s = std::sin(12.9898 * x + 78.233 * y + 37.719 * z + seed) * 43758.5453;
    return s - std::floor(s);
  };
}

struct SampledRay
{
  tetmarch::testing::Vec3 Point{};
  tetmarch::testing::Vec3 Direction{};
  double Begin = 0; // lengths in units of the frame
  double End = 0;
  double Shift = 1; // of the first sample, in steps
};

struct Sampling
{
  Rgba Color{};
  long Samples = 0;
};

// Where the ray leaves the volume.
double lastOf(const StructuredRays& rays, const SampledRay& ray)
{
  const double r = rays.Cells.Frame.Radius;
  const Vector3 o = rays.Cells.Frame.toData({ { ray.Point[0], ray.Point[1], ray.Point[2] } });
  return rays.Truth.segments({ o[0], o[1], o[2] }, ray.Direction, ray.Begin * r, 4 * r).back().T1;
}

// Each sample is looked for in all segments of the ray.
Sampling bruteForce(
  const StructuredRays& rays, const OpticalModel& model, const SampledRay& ray, double step)
{
  const double r = rays.Cells.Frame.Radius;
  const Vector3 o = rays.Cells.Frame.toData({ { ray.Point[0], ray.Point[1], ray.Point[2] } });
  const auto segments =
    rays.Truth.segments({ o[0], o[1], o[2] }, ray.Direction, ray.Begin * r, ray.End * r);
  Sampling found;
  if (segments.empty())
  {
    return found;
  }
  double transmittance = 1;
  // So that one on the last plane counts, whatever rounding does.
  const double begin = segments.front().T0 + (ray.Shift - 1e-4) * step;
  // Without jitter there is one sample at least, also where a ray ends in the volume before.
  const double first = ray.Shift < 1 ? begin : std::min(begin, lastOf(rays, ray) - 1e-4 * step);
  for (long k = 0; first + k * step <= segments.back().T1; ++k)
  {
    const double t = first + k * step;
    const auto at = std::find_if(segments.begin(), segments.end(),
      [t](const ScalarSegment& segment) { return t >= segment.T0 && t <= segment.T1; });
    if (at == segments.end())
    {
      continue;
    }
    const double scalar = at->Scalar.at((t - at->T0) / (at->T1 - at->T0));
    const double opacity = 1 - std::exp(-model.extinction(scalar) * step);
    const tetmarch::testing::Vec3 color = model.colour(scalar);
    for (int c = 0; c < 3; ++c)
    {
      found.Color[c] += transmittance * opacity * color[c];
    }
    transmittance *= 1 - opacity;
    ++found.Samples;
  }
  found.Color[3] = 1 - transmittance;
  return found;
}

SampledRay randomRay(const StructuredRays& rays, std::mt19937& random, int i)
{
  SampledRay ray;
  ray.Point = rays.pointNear(random, 1.1);
  ray.Direction = StructuredRays::direction(random);
  ray.Begin = i % 3 ? -4.0 : 0.1 * StructuredRays::share(random);
  ray.End = i % 5 ? 4.0 : ray.Begin + 0.7 * StructuredRays::share(random);
  ray.Shift = i % 2 ? 1.0 : StructuredRays::share(random);
  return ray;
}

struct Worst
{
  double Error = 0; // of a channel
  long Samples = 0;
  long OtherNumber = 0; // of rays that took more or fewer samples than brute force
};

template <typename Kernel, typename Real>
Worst compareWithBruteForce(
  const StructuredRays& rays, const OpticalModel& model, double step, unsigned seed)
{
  auto kernel = rays.kernel<Kernel, Real>();
  kernel.useSamples({ step, false }, rays.Cells.Frame);
  std::mt19937 random(seed);
  Worst worst;
  for (int i = 0; i < 300; ++i)
  {
    const SampledRay sampled = randomRay(rays, random, i);
    const auto& p = sampled.Point;
    const auto& d = sampled.Direction;
    auto ray = kernel.rayThrough(
      { Real(p[0]), Real(p[1]), Real(p[2]) }, { Real(d[0]), Real(d[1]), Real(d[2]) });
    const double offset = p[0] * d[0] + p[1] * d[1] + p[2] * d[2];
    const Real begin = Real(sampled.Begin + offset);
    kernel.placeSamples(begin, ray);
    kernel.shiftSamples(Real(sampled.Shift), ray);
    const auto march =
      kernel.castPlainRay(ray, Real(rays.PerDepth), begin, Real(sampled.End + offset));
    const Sampling truth = bruteForce(rays, model, sampled, step);
    const Rgba color{ { double(march.radiance.color.x), double(march.radiance.color.y),
      double(march.radiance.color.z), 1.0 - double(march.radiance.transmittance) } };
    for (int c = 0; c < 4; ++c)
    {
      EXPECT_TRUE(std::isfinite(color[c]));
      worst.Error = std::max(worst.Error, std::abs(color[c] - truth.Color[c]));
    }
    worst.Samples += truth.Samples;
    worst.OtherNumber += march.lookups != truth.Samples ? 1 : 0;
    EXPECT_EQ(march.lost + march.guarded, 0);
    EXPECT_EQ(double(kernel.errorBound(march.radiance)), 1);
  }
  return worst;
}

template <typename Real>
Worst compareWithBruteForce(
  const StructuredRays& rays, const OpticalModel& model, double step, unsigned seed)
{
  return rays.Cells.Constant
           ? compareWithBruteForce<SampledConstantKernel<Real>, Real>(rays, model, step, seed)
           : compareWithBruteForce<SampledTrilinearKernel<Real>, Real>(rays, model, step, seed);
}

TEST(SampledMarch, IsBruteForceWhereverImagesAre)
{
  for (const ImagePlace& place : imagePlaces())
  {
    const auto image = imageOf(noise(1), place);
    const double length = image->GetLength();
    for (const LatticeValues values : { LatticeValues::PointsLinear, LatticeValues::PointsNearest,
           LatticeValues::CellsLinear, LatticeValues::CellsNearest })
    {
      SCOPED_TRACE(place.Name + ", values " + std::to_string(int(values)));
      const OpticalModel model = rampAndPeak(0.1 * length);
      const StructuredRays rays(image, values, model, FineSamples);
      for (const double step : { 0.0437 * length, 0.0113 * length })
      {
        const Worst worst = compareWithBruteForce<double>(rays, model, step, 3);
        EXPECT_LE(worst.Error, 1e-5);
        EXPECT_EQ(worst.OtherNumber, 0);
        EXPECT_GT(worst.Samples, 300);
      }
    }
  }
}

TEST(SampledMarch, IsBruteForceByTheLogarithmicLaw)
{
  OpticalModel model = rampAndPeak(0.2);
  model.Law = tetmarch::testing::OpacityLaw::Logarithmic;
  const StructuredRays rays(
    imageOf(noise(2), unitCube(6)), LatticeValues::PointsLinear, model, FineSamples);
  const Worst worst = compareWithBruteForce<double>(rays, model, 0.04, 5);
  EXPECT_LE(worst.Error, 1e-5);
  EXPECT_EQ(worst.OtherNumber, 0);
}

TEST(SampledMarch, IsTheSameInFloat)
{
  OpticalModel model = rampAndPeak(0.2);
  const StructuredRays rays(
    imageOf(sineField(), unitCube(16)), LatticeValues::PointsLinear, model, FineSamples);
  for (const double step : { 0.0625, 0.004 })
  {
    const Worst worst = compareWithBruteForce<float>(rays, model, step, 6);
    std::cout << "[ MEASURED ] step " << step << " in float: " << worst.Error << ", "
              << worst.OtherNumber << " rays of 300 with another number of samples\n";
    EXPECT_LE(worst.Error, 0.1 / 255);
  }
}

TEST(RaySamples, AreRefusedWhereFloatCanNotTellThemApart)
{
  VolumeFrame frame;
  frame.Radius = 50;
  for (const double bad : { 0.0, 0.9e-4, std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity() })
  {
    EXPECT_NE(
      describeBadDistance({ bad, false }, frame).find("the sample distance is"), std::string::npos)
      << bad;
  }
  EXPECT_EQ(describeBadDistance({ 1.1e-4, false }, frame), "");
  EXPECT_EQ(describeBadDistance({ 1e6, false }, frame), "");
  EXPECT_DOUBLE_EQ((RaySamples{ 5, false }.step(frame)), 0.1);
}
} // namespace
