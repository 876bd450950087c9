// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a ray gathers in one tetrahedron, thin or thick, against quadrature of VTK's functions.
#include "Reference/PointKernel.h"
#include "Scalars/StoredScalar.h"

#include "ClosedForms.h"
#include "GroundTruth.h"
#include "RandomRays.h"
#include "UnitMeshes.h"

#include "vtkNew.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

using Point = std::array<double, 3>;

enum class Shape
{
  Smooth,
  Steps,
  Spikes
};

// Nodes stand on samples of a table, so that table and functions are the same.
OpticalModel modelOf(Shape shape, const AccuracyLevel& level)
{
  const double bins = samplesOfTable(level.LeastTableEntries) - 1;
  const auto at = [bins](double f, int offset = 0)
  { return (std::round(f * bins) + offset) / bins; };
  OpticalModel model;
  model.Colour = vtkSmartPointer<vtkColorTransferFunction>::New();
  model.Opacity = vtkSmartPointer<vtkPiecewiseFunction>::New();
  const double colours[6][3] = { { 1, 0, 0 }, { 0, 0.2, 1 }, { 1, 1, 0 }, { 0, 1, 0.3 },
    { 1, 0, 1 }, { 0, 0, 0 } };
  for (int i = 0; i < 6; ++i)
  {
    const double f = at(0.2 * i);
    const double opacity = i % 2 ? 0.8 : 0.1;
    if (shape == Shape::Smooth || i == 0)
    {
      model.Colour->AddRGBPoint(f, colours[i][0], colours[i][1], colours[i][2]);
      model.Opacity->AddPoint(f, opacity);
      continue;
    }
    const double* before = colours[i - 1];
    model.Colour->AddRGBPoint(at(0.2 * i, -1), before[0], before[1], before[2]);
    model.Colour->AddRGBPoint(f, colours[i][0], colours[i][1], colours[i][2]);
    if (shape == Shape::Steps)
    {
      model.Opacity->AddPoint(at(0.2 * i, -1), i % 2 ? 0.0 : 1.0);
      model.Opacity->AddPoint(f, i % 2 ? 1.0 : 0.0);
    }
    else if (i < 5)
    {
      model.Opacity->AddPoint(at(0.2 * i - 0.1, -1), 0.0);
      model.Opacity->AddPoint(at(0.2 * i - 0.1), 1.0);
      model.Opacity->AddPoint(at(0.2 * i - 0.1, 1), 0.0);
    }
  }
  if (shape != Shape::Smooth)
  {
    model.Opacity->AddPoint(1.0, shape == Shape::Steps ? 1.0 : 0.5);
  }
  return model;
}

IntegralTable tableOfModel(const OpticalModel& model, const AccuracyLevel& level)
{
  vtkNew<vtkVolumeProperty> property;
  property->SetColor(model.Colour);
  property->SetScalarOpacity(model.Opacity);
  constexpr int perBin = 16;
  const int bins = samplesOfTable(level.LeastTableEntries) - 1;
  const SampledFunctions functions = keepAreas(
    sampleFunctions(property, tetmarch::OpacityLaw::Unstructured, 0.0, 1.0, bins * perBin + 1),
    perBin);
  EXPECT_EQ(functions.Begin, 0.0);
  EXPECT_EQ(functions.End, 1.0);
  return makeIntegralTable(functions);
}

// The quadrature of the ground truth sees nothing of a chord so thick that the optical depth at its
// first node is some hundreds. So it gets parts of the chord, each half as long as the one behind.
std::array<double, 4> integrateThick(
  const GroundTruthScene& groundTruth, const Point& o, const Point& d)
{
  const auto lengthUpTo = [&](double t) { return groundTruth.pathLength(o, d, -1e30, t); };
  const double length = lengthUpTo(1e30);
  double begin = -2.0, behind = 2.0; // where the chord begins
  for (int i = 0; i < 60; ++i)
  {
    const double middle = 0.5 * (begin + behind);
    (lengthUpTo(middle) > 0.0 ? behind : begin) = middle;
  }
  std::array<double, 4> sum{};
  double from = -1e30;
  for (int i = 24; i >= 0; --i)
  {
    const double to = i == 0 ? 1e30 : begin + std::ldexp(length, -i);
    const auto part = groundTruth.integrate(o, d, from, to);
    for (int k = 0; k < 4; ++k)
    {
      // The opacity comes last, since the others are weighted by it.
      sum[k] += (1.0 - sum[3]) * part[k];
    }
    from = to;
  }
  return sum;
}

struct Tally
{
  double Worst = 0.0;
  double WorstBeyondBound = -1.0; // how far an error is from the bound that the march gives
  int Segments = 0;
  int Seen = 0;
  int Lookups = 0;
};

// One ray through one tetrahedron, scalars from middle - width / 2 to middle + width / 2.
template <typename Real>
void compareSegments(Shape shape, const AccuracyLevel& level, double length, Tally& tally)
{
  TetMesh mesh = builtWithHierarchy(singleTet());
  OpticalModel model = modelOf(shape, level);
  const IntegralTable table = tableOfModel(model, level);
  auto kernel = kernelOf<PointKernel<Real>, Real>(mesh, table, level);
  model.UnitDistance = 1.0 / length;
  std::mt19937 random(51);
  for (int i = 0; i < 80; ++i)
  {
    const double width = std::pow(10.0, -9.0 * uniform(random) * (i % 2));
    const double first = (1.0 - width) * uniform(random);
    for (Vertex& v : mesh.Vertices)
    {
      const double share = uniform(random);
      v.Scalar = static_cast<float>(first + width * share);
    }
    const GroundTruthScene groundTruth(asGrid(mesh), model);
    RandomRays rays(static_cast<unsigned>(i));
    for (int j = 0; j < 4; ++j)
    {
      const auto ray = rays.next<PointKernel<Real>, Real>(kernel, mesh);
      const auto march = kernel.castPlainRay(ray, Real(length), Real(-1e30f), Real(1e30f));
      if (rays.LastKind != RandomRays::Kind::Generic || march.cells == 0)
      {
        continue;
      }
      const Point o{ double(ray.origin.x), double(ray.origin.y), double(ray.origin.z) };
      const Point d{ double(ray.direction.x), double(ray.direction.y), double(ray.direction.z) };
      const auto expected = integrateThick(groundTruth, o, d);
      const double found[4] = { double(march.radiance.color.x), double(march.radiance.color.y),
        double(march.radiance.color.z), 1.0 - double(march.radiance.transmittance) };
      const double bound = double(kernel.errorBound(march.radiance));
      for (int k = 0; k < 4; ++k)
      {
        ASSERT_TRUE(std::isfinite(found[k]));
        const double error = std::abs(found[k] - expected[k]);
        tally.Worst = std::max(tally.Worst, error);
        tally.WorstBeyondBound = std::max(tally.WorstBeyondBound, error - bound);
      }
      ASSERT_GE(march.radiance.transmittance, Real(0));
      ASSERT_LE(march.radiance.transmittance, Real(1));
      ++tally.Segments;
      tally.Seen += expected[3] > 0.0 ? 1 : 0;
      tally.Lookups += march.lookups;
    }
  }
}

constexpr double Lengths[] = { 1e-3, 0.03, 1.0, 10.0, 100.0, 1e3, 1e4 };
constexpr Shape Shapes[] = { Shape::Smooth, Shape::Steps, Shape::Spikes };

// Errors that the bound leaves out: float rounds positions in the table to 2^-15 bins, in which a
// colour may go from 0 to 1; the integrals are good to 2^-22 of the greatest mean.
template <typename Real>
void expectAccuracy(const Tally& tally, double bound, double length, Shape shape)
{
  const double slack = std::ldexp(1.0, std::is_same<Real, float>::value ? -15 : -19);
  EXPECT_GT(tally.Segments, 50);
  EXPECT_LT(tally.WorstBeyondBound, slack) << "thickness " << length;
  EXPECT_LT(tally.Worst, bound) << "thickness " << length << " shape " << static_cast<int>(shape);
}

// The tolerance holds whatever a ray meets, and the error bound holds even where the tolerance
// doesn't.
template <typename Real>
void expectDefaultAccuracy()
{
  double worst = 0.0;
  for (const double length : Lengths)
  {
    for (const Shape shape : Shapes)
    {
      Tally tally;
      compareSegments<Real>(shape, DefaultAccuracy, length, tally);
      expectAccuracy<Real>(tally, DefaultAccuracy.ErrorTolerance, length, shape);
      worst = std::max(worst, tally.Worst);
      // Thin segments take one lookup each, or none where the table says that nothing is seen.
      if (length <= 0.03)
      {
        EXPECT_LE(tally.Lookups, tally.Segments);
        EXPECT_GE(tally.Lookups, tally.Seen);
      }
    }
  }
  ::testing::Test::RecordProperty("worst", std::to_string(worst));
}

TEST(Segment, DefaultAccuracyInFloat) { expectDefaultAccuracy<float>(); }

TEST(Segment, DefaultAccuracyInDouble) { expectDefaultAccuracy<double>(); }

void expectGroundTruthAccuracy(double from, double to)
{
  for (const double length : Lengths)
  {
    for (const Shape shape : Shapes)
    {
      if (length >= from && length <= to)
      {
        Tally tally;
        compareSegments<double>(shape, GroundTruthAccuracy, length, tally);
        expectAccuracy<double>(tally, 1e-4, length, shape);
      }
    }
  }
}

TEST(Segment, GroundTruthAccuracy) { expectGroundTruthAccuracy(0.0, 1.0); }

// Far more trials than the 64 of the default level are needed for a tolerance of 1e-6 in a cell of
// optical depth 10 (with 64 the error is 1.3e-2). Beyond depths of 1000 the fixed-point integrals,
// good to 2^-22 of the greatest mean, leave more than 1e-4.
TEST(Segment, GroundTruthAccuracyInThickCells) { expectGroundTruthAccuracy(10.0, 1e3); }

// Neither an infinite length nor a position that is not a number keeps a ray from ending.
TEST(Segment, EndsWhateverTheInput)
{
  auto kernel = kernelOf<PointKernel<float>, float>(TetMesh(), whiteTable(), DefaultAccuracy);
  const float inf = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const float begin : { 0.1f, nan })
  {
    for (const float end : { 0.2f, nan })
    {
      for (const float length : { 1.0f, inf, nan })
      {
        auto radiance = kernel.noRadiance();
        PointKernel<float>::CellInterval cell{};
        EXPECT_LE(
          kernel.integrateSegment({ { 0.0f, begin }, { 1.0f, end } }, length, cell, radiance),
          2 * DefaultAccuracy.MostTrials);
      }
    }
  }
}
} // namespace
