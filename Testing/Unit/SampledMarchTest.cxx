// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Samples at even distances against brute force: the cells that a ray meets, the scalar in them and
// the functions are those of the ground truth, in double precision.
#include "StructuredRays.h"

#include "Reference/SampledConstantKernel.h"
#include "Reference/SampledTrilinearKernel.h"
#include "View/RaySamples.h"

#include <algorithm>
#include <iostream>
#include <limits>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

// Tables as fine as the ground truth has them, and rays that end when nothing is left.
constexpr AccuracyLevel FineSamples{ false, 1e-9, 1, 65536, 262144, true };

struct SampledRay : LatticePart
{
  double Shift = 1; // of the first sample, in steps
};

struct Sampling
{
  Rgba Color{};
  long Samples = 0;
};

// Each sample is looked for in all segments of the ray. Depths and the step are in units of the
// frame.
Sampling bruteForce(
  const StructuredRays& rays, const OpticalModel& model, const SampledRay& ray, double step)
{
  const auto segments = rays.segments(ray, ray.End);
  Sampling found;
  if (segments.empty())
  {
    return found;
  }
  double transmittance = 1;
  // So that one on the last plane counts, whatever rounding does.
  const double begin = segments.front().T0 + (ray.Shift - 1e-4) * step;
  // Without jitter there is one sample at least, also where a ray ends in the volume before.
  const double last = rays.segments(ray, ray.offset() + 4).back().T1; // where it leaves the volume
  const double first = ray.Shift < 1 ? begin : std::min(begin, last - 1e-4 * step);
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
    const double length = step * rays.Cells.Frame.Radius;
    const double opacity = 1 - std::exp(-model.extinction(scalar) * length);
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

struct Worst
{
  double Error = 0; // of a channel
  long Samples = 0;
  long OtherNumber = 0; // of rays that took more or fewer samples than brute force
};

template <typename Kernel>
Worst compareWithBruteForce(
  const StructuredRays& rays, const OpticalModel& model, double step, unsigned seed)
{
  using Real = RealOf<Kernel>;
  auto kernel = rays.kernel<Kernel>();
  kernel.useSamples({ step, false }, rays.Cells.Frame);
  std::mt19937 random(seed);
  RayTally tally;
  Worst worst;
  for (int i = 0; i < 300; ++i)
  {
    SampledRay sampled{ rays.nextPart(random, i) };
    sampled.End = i % 5 ? sampled.End : sampled.Begin + 0.7 * uniform(random);
    sampled.Shift = i % 2 ? 1.0 : uniform(random);
    auto ray = sampled.of(kernel);
    kernel.placeSamples(Real(sampled.Begin), ray);
    kernel.shiftSamples(Real(sampled.Shift), ray);
    const auto march = marchOf(kernel, ray, sampled);
    const Sampling truth = bruteForce(rays, model, sampled, step / rays.Cells.Frame.Radius);
    tally.add(pixelOf(kernel, march, sampled), truth.Color, 1);
    worst.Samples += truth.Samples;
    worst.OtherNumber += march.lookups != truth.Samples ? 1 : 0;
    EXPECT_EQ(march.lost + march.guarded, 0);
    EXPECT_EQ(double(kernel.errorBound(march.radiance)), 1);
  }
  worst.Error = tally.Worst;
  return worst;
}

TEST(SampledMarch, IsBruteForceWhereverImagesAre)
{
  for (const ImagePlace& place : imagePlaces())
  {
    const auto image = imageOf(scatteredField(1), place);
    const double length = image->GetLength();
    for (const LatticeValues values : AllLatticeValues)
    {
      SCOPED_TRACE(place.Name + ", values " + std::to_string(int(values)));
      const OpticalModel model = rampAndPeak(0.1 * length);
      const StructuredRays rays(image, values, model, FineSamples);
      for (const double step : { 0.0437 * length, 0.0113 * length })
      {
        const Worst worst =
          rays.Cells.Constant
            ? compareWithBruteForce<SampledConstantKernel<double>>(rays, model, step, 3)
            : compareWithBruteForce<SampledTrilinearKernel<double>>(rays, model, step, 3);
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
    imageOf(scatteredField(2), unitCube(6)), LatticeValues::PointsLinear, model, FineSamples);
  const Worst worst = compareWithBruteForce<SampledTrilinearKernel<double>>(rays, model, 0.04, 5);
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
    const Worst worst = compareWithBruteForce<SampledTrilinearKernel<float>>(rays, model, step, 6);
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
