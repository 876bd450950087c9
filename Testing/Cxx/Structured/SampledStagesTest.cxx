// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The accuracy level Sampled: which distance it takes, what stays exact, and what it refuses.
#include "ErrorWatch.h"
#include "SampledScene.h"

#include "vtkTetMarchFrameStatistics.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

// How many samples each ray takes tells their distance: seen down z each chord is 1.
int samplesOf(StructuredScene& scene)
{
  scene.render();
  const auto* statistics = scene.Mapper->GetLastFrameStatistics();
  const int lookups = vtkTetMarchFrameStatistics::LOOKUPS;
  return static_cast<int>(const_cast<vtkTetMarchFrameStatistics*>(statistics)->GetMaximum(lookups));
}

TEST(SampledStages, TakesTheDistanceThatIsAskedFor)
{
  ImagePlace place = unitCube(10);
  place.Extent = { 0, 20, 0, 10, 0, 5 };
  place.Spacing = { 0.05, 0.1, 0.2 };
  SampledScene scene(imageOf(sineField(), place), 0.1);
  setPlainFunctions(scene.property(), { 0.4, 0.5, 0.6 }, 0.01);
  scene.property()->SetScalarOpacityUnitDistance(1);
  lookDownZ(scene.camera(), 0.4);
  scene.Renderer->ResetCameraClippingRange();
  EXPECT_EQ(samplesOf(scene), 10); // the last one lies on the far side
  scene.Mapper->SetSampleDistance(0.03f);
  EXPECT_EQ(samplesOf(scene), 33);
  // Half of the mean spacing, 0.0583, times 0.01 + 0.99 * 1000^0.333 / 100.
  constexpr int ofSpacing = 157;
  scene.Mapper->LockSampleDistanceToInputSpacingOn();
  EXPECT_EQ(samplesOf(scene), ofSpacing);
  scene.Mapper->LockSampleDistanceToInputSpacingOff();
  scene.Mapper->SetSampleDistance(-1.0f);
  EXPECT_EQ(samplesOf(scene), ofSpacing);
  scene.Mapper->SetSampleDistance(0.5f);
  EXPECT_EQ(samplesOf(scene), 2);
  scene.Mapper->AutoAdjustSampleDistancesOn(); // the least spacing; there is time for all rays
  EXPECT_EQ(samplesOf(scene), 20);
}

TEST(SampledStages, OtherBlendModesStayExact)
{
  SampledScene scene(imageOf(sineField()), 0.5);
  for (const int mode : { vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND,
         vtkVolumeMapper::AVERAGE_INTENSITY_BLEND, vtkVolumeMapper::ISOSURFACE_BLEND })
  {
    SCOPED_TRACE(mode);
    scene.setSurfaces({ 0.4, 0.6 });
    scene.Mapper->SetBlendMode(mode);
    const Image drawn = scene.render();
    const Difference difference = compare(drawn, scene.truth());
    EXPECT_LE(difference.Rms, 0.3 / 255.0) << difference.text();
  }
}

TEST(SampledStages, HasNoErrorBound)
{
  SampledScene scene(imageOf(sineField()));
  scene.render();
  EXPECT_EQ(
    scene.Mapper->GetLastFrameStatistics()->GetMaximum(vtkTetMarchFrameStatistics::ERROR_BOUND), 1);
  EXPECT_EQ(std::string(scene.Mapper->GetUsedAccuracyLevelAsString()), "Sampled");
  EXPECT_TRUE(scene.Mapper->CompareWithGroundTruth(scene.Volume));
  EXPECT_GT(
    scene.Mapper->GetLastFrameStatistics()->GetMaximum(vtkTetMarchFrameStatistics::TRUE_ERROR),
    0.001);
  ErrorWatch watch(scene.Mapper);
  scene.Mapper->SetViewModeToErrorBound();
  scene.Window->Render();
  ASSERT_EQ(watch.Errors.size(), 1u);
  EXPECT_NE(watch.Errors[0].find("the accuracy level is Sampled"), std::string::npos)
    << watch.Errors[0];
}

TEST(SampledStages, RefusesDistancesThatAreNone)
{
  SampledScene scene(imageOf(sineField()), 0);
  ErrorWatch watch(scene.Mapper);
  scene.Window->Render();
  ASSERT_EQ(watch.Errors.size(), 1u);
  EXPECT_NE(watch.Errors[0].find("the sample distance is 0"), std::string::npos) << watch.Errors[0];
  scene.Mapper->SetSampleDistance(0.1f);
  scene.Window->Render();
  EXPECT_EQ(watch.Errors.size(), 1u);
}

TEST(SampledStages, IsNotForTetrahedra)
{
  Scene scene(jitteredLattice(3));
  scene.Mapper->SetAccuracyLevelToSampled();
  ErrorWatch watch(scene.Mapper);
  scene.Window->Render();
  ASSERT_EQ(watch.Errors.size(), 1u);
  EXPECT_NE(watch.Errors[0].find("is for images and rectilinear grids alone"), std::string::npos)
    << watch.Errors[0];
}
} // namespace
