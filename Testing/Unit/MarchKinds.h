// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What the march promises of every kind of volume with several components
 *
 * A kind is a volume, its components and its kernels. The volume is a class with
 *   Rays                      what is marched: StructuredRays or its like, with use(), kernel(),
 *                             forEachRay() and truth()
 *   forEach(components, independent, call)
 *                             calls with Rays of scalars that are linear or trilinear in cells
 *   forEachPlace(...)         calls with Rays of each place that values may have
 *   TruthError                how far the truth itself may be off
 *   RaysOfAPlace              number of rays that are compared with the truth there
 *   TrialFactor               as Frame/FrameStages.cxx has it
 */
#ifndef tetmarch_testing_MarchKinds_h
#define tetmarch_testing_MarchKinds_h

#include "Optics/AccuracyLevel.h"

#include "ClosedForms.h"
#include "ComponentFields.h"
#include "CubeChord.h"
#include "RayTally.h"

#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>

namespace tetmarch::testing
{
/// Whole takes segments as they are. Constant is for scalars that are constant in cells.
template <typename VolumeOf, int Count, bool AreIndependent, template <typename> class KernelOf,
  template <typename> class WholeOf, template <typename> class ConstantOf>
struct MarchKind
{
  using Volume = VolumeOf;
  template <typename Real>
  using Kernel = KernelOf<Real>;
  template <typename Real>
  using Whole = WholeOf<Real>;
  template <typename Real>
  using Constant = ConstantOf<Real>;
  static constexpr int Components = Count;
  static constexpr bool Independent = AreIndependent;
};

struct KindNames
{
  template <typename Kind>
  static std::string GetName(int)
  {
    const char* const independent[] = { "TwoIndependent", "ThreeIndependent", "FourIndependent" };
    return Kind::Independent       ? independent[Kind::Components - 2]
           : Kind::Components == 2 ? "ColorAndOpacity"
                                   : "DirectColor";
  }
};

template <typename Kind>
class MarchOf : public ::testing::Test
{
protected:
  using Volume = typename Kind::Volume;

  template <typename Function>
  void forEach(const Function& call) const
  {
    Volume::forEach(Kind::Components, Kind::Independent, call);
  }

  /// Error bounds leave out what functions do between the entries of a table, so tables are fine.
  static AccuracyLevel fine(AccuracyLevel level)
  {
    level.LeastTableEntries = 16384;
    level.MostTableEntries = std::max(level.MostTableEntries, level.LeastTableEntries);
    return level;
  }

  template <typename Real, typename Rays>
  static RayTally truthTally(const Rays& rays, bool constant)
  {
    RayTally tally;
    constant ? tallyTruth<typename Kind::template Constant<Real>>(tally, rays, Volume::RaysOfAPlace)
             : tallyTruth<typename Kind::template Kernel<Real>>(tally, rays, Volume::RaysOfAPlace);
    return tally;
  }
};
TYPED_TEST_SUITE_P(MarchOf);

// In float, by a bound that holds.
TYPED_TEST_P(MarchOf, KeepsTheTolerance)
{
  for (const double tolerance : { 1.0 / 32.0, 1.0 / 255.0, 1.0 / 1024.0 })
  {
    AccuracyLevel level = this->fine(levelOf(Accuracy::Default, tolerance));
    level.MostTrials *= TypeParam::Volume::TrialFactor;
    this->forEach(
      [&](auto& rays)
      {
        ASSERT_EQ(rays.use(level), "");
        RayTally tally;
        tallyTruth<typename TypeParam::template Kernel<float>>(tally, rays, 400);
        report("tolerance", tally);
        EXPECT_GT(tally.Rays, 150);
        EXPECT_LE(tally.Worst, tolerance);
        EXPECT_LE(tally.BeyondBound, Rounding);
        EXPECT_EQ(tally.Lost, 0);
      });
  }
}

// All that a level of the ground truth leaves, wherever values are.
TYPED_TEST_P(MarchOf, IsTheTruth)
{
  TypeParam::Volume::forEachPlace(TypeParam::Components, TypeParam::Independent,
    [&](auto& rays, bool constant)
    {
      ASSERT_EQ(rays.use(GroundTruthAccuracy), "");
      const RayTally exact = this->template truthTally<double>(rays, constant);
      report("in double", exact);
      EXPECT_LE(exact.Worst, 5e-6);
      EXPECT_EQ(exact.Lost, 0);
      const RayTally single = this->template truthTally<float>(rays, constant);
      report("in float", single);
      EXPECT_LE(single.Worst, Rounding);
      EXPECT_EQ(single.Lost, 0);
    });
}

// Segments that are integrated whole promise nothing, but say by how much they may be off.
TYPED_TEST_P(MarchOf, BoundsWholeSegments)
{
  AccuracyLevel level = this->fine(levelOf(Accuracy::Fast, 1));
  level.MostTrials = 0;
  RayTally tally;
  this->forEach(
    [&](auto& rays)
    {
      if constexpr (TypeParam::Volume::IsLit)
      {
        rays.blaze();
      }
      ASSERT_EQ(rays.use(level), "");
      tallyTruth<typename TypeParam::template Whole<double>>(tally, rays, 600);
    });
  report("whole segments", tally);
  EXPECT_LE(tally.BeyondBound, TypeParam::Volume::TruthError);
  EXPECT_GT(tally.Worst, 1e-2);
  EXPECT_LE(tally.Bound, 40 * tally.Error);
}

REGISTER_TYPED_TEST_SUITE_P(MarchOf, KeepsTheTolerance, IsTheTruth, BoundsWholeSegments);

/// Direct colours that change linearly in an even fog, in closed form. The scalars of the rays are
/// componentFields(4).
template <typename Kernel, typename Rays>
void expectLinearColors(Rays& rays)
{
  vtkNew<vtkPiecewiseFunction> even;
  even->AddPoint(0.0, 0.7);
  rays.Property->SetScalarOpacity(even);
  ASSERT_EQ(rays.use(GroundTruthAccuracy), "");
  const std::vector<Field> fields = componentFields(4);
  int met = 0;
  RayTally tally;
  tallyRays(tally, rays, rays.template kernel<Kernel>(), 400,
    [&](const auto& ray, const auto& part)
    {
      Rgba seen{};
      for (int k = 0; k < 3; ++k)
      {
        const ScalarChord whole = rays.chordOf(ray, fields[k]);
        const double begin = std::max(whole.Begin, part.Begin);
        const double end = std::min(whole.End, part.End);
        if (end - begin > 1e-9)
        {
          const double length = part.perDepth() * (end - begin);
          seen[k] = slabColour(whole.scalarAt(begin), whole.scalarAt(end), 0.7, length);
          seen[3] = slabOpacity(0.7, length);
        }
      }
      met += seen[3] > 0 ? 1 : 0;
      return seen;
    });
  EXPECT_LE(tally.Worst, 3e-6);
  EXPECT_GT(met, 200);
}
} // namespace tetmarch::testing

#endif
