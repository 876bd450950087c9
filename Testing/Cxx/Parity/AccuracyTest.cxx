// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The levels of accuracy: each drawn as the CPU reference does, and what a switch costs.
#include "CpuReference.h"
#include "ErrorWatch.h"

#include "vtkFloatArray.h"
#include "vtkTetMarchFrameStatistics.h"

#include <cmath>
#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch::testing;

const Grid& noise()
{
  static const Grid grid = jitteredLattice(10, 0.15, 5, noiseField());
  return grid;
}

constexpr int Levels[] = { vtkTetMarchVolumeMapper::FAST, vtkTetMarchVolumeMapper::DEFAULT,
  vtkTetMarchVolumeMapper::ACCURATE, vtkTetMarchVolumeMapper::REFERENCE };

TEST(Accuracy, EveryLevelIsDrawnAsTheReferenceDoes)
{
  for (const int level : Levels)
  {
    Scene scene(noise());
    setSpikyFunctions(scene.property());
    scene.Mapper->SetAccuracyLevel(level);
    SCOPED_TRACE(scene.Mapper->GetAccuracyLevelAsString());
    expectParity(scene);
  }
}

TEST(Accuracy, FromLevelToLevelNothingIsWorse)
{
  Scene scene(noise());
  setSpikyFunctions(scene.property());
  scene.property()->SetScalarOpacityUnitDistance(0.02);
  scene.Mapper->SetAccuracyLevelToReference();
  scene.Mapper->CollectDiagnosticsOn();
  scene.Window->Render();
  const Image reference = floatPictureOf(scene.Mapper, SceneSize, SceneSize);
  vtkTypeInt64 lookups = 0;
  for (const int level : Levels)
  {
    scene.Mapper->SetAccuracyLevel(level);
    scene.Window->Render();
    EXPECT_GE(scene.Mapper->GetNumberOfLookups(), lookups);
    lookups = scene.Mapper->GetNumberOfLookups();
    const Difference difference =
      compare(floatPictureOf(scene.Mapper, SceneSize, SceneSize), reference);
    std::cout << "[ MEASURED ] " << scene.Mapper->GetAccuracyLevelAsString() << ": "
              << difference.text() << ", " << lookups << " lookups\n";
  }
}

TEST(Accuracy, PicturesKeepTheTolerance)
{
  Scene scene(noise());
  setBumpyFunctions(scene.property());
  scene.property()->SetScalarOpacityUnitDistance(0.05);
  scene.Mapper->CollectDiagnosticsOn();
  scene.Mapper->SetErrorTolerance(1e-5);
  scene.Window->Render();
  const Image reference = floatPictureOf(scene.Mapper, SceneSize, SceneSize);
  vtkTypeInt64 lookups = scene.Mapper->GetNumberOfLookups();
  for (const double tolerance : { 1.0 / 1024.0, 1.0 / 255.0, 1.0 / 32.0 })
  {
    scene.Mapper->SetErrorTolerance(tolerance);
    scene.Window->Render();
    const Difference difference =
      compare(floatPictureOf(scene.Mapper, SceneSize, SceneSize), reference);
    EXPECT_LE(difference.Max, tolerance + 1e-5) << difference.text();
    EXPECT_GT(difference.Max, 0.0);
    EXPECT_LT(scene.Mapper->GetNumberOfLookups(), lookups);
    lookups = scene.Mapper->GetNumberOfLookups();
  }
  EXPECT_EQ(scene.Mapper->GetMeshBuilds(), 1);
  EXPECT_EQ(scene.Mapper->GetScalarsBuilds(), 1);
}

TEST(Accuracy, ToleranceIsClamped)
{
  vtkNew<vtkTetMarchVolumeMapper> mapper;
  EXPECT_EQ(mapper->GetAccuracyLevel(), vtkTetMarchVolumeMapper::DEFAULT);
  EXPECT_EQ(mapper->GetErrorTolerance(), 1.0 / 255.0);
  mapper->SetErrorTolerance(0.0);
  EXPECT_EQ(mapper->GetErrorTolerance(), 1e-6);
  mapper->SetErrorTolerance(7.0);
  EXPECT_EQ(mapper->GetErrorTolerance(), 1.0);
  mapper->SetAccuracyLevel(9);
  EXPECT_STREQ(mapper->GetAccuracyLevelAsString(), "Sampled");
}
using Statistics = vtkTetMarchFrameStatistics;

TEST(Accuracy, StatisticsAreThoseOfTheFrame)
{
  Scene scene(noise());
  setBumpyFunctions(scene.property());
  Statistics* statistics = scene.Mapper->GetLastFrameStatistics();
  scene.Mapper->CollectDiagnosticsOff();
  scene.Window->Render();
  EXPECT_EQ(statistics->GetNumberOfPixels(Statistics::CELLS), 0);
  EXPECT_GT(statistics->GetSeconds(), 0.0);
  scene.Mapper->CollectDiagnosticsOn();
  scene.Window->Render();
  EXPECT_EQ(statistics, scene.Mapper->GetLastFrameStatistics());
  const vtkIdType pixels = statistics->GetNumberOfPixels(Statistics::CELLS);
  EXPECT_EQ(pixels, scene.Mapper->GetNumberOfRays());
  EXPECT_NEAR(statistics->GetMean(Statistics::CELLS) * double(pixels),
    double(scene.Mapper->GetNumberOfCrossedCells()), 0.5);
  EXPECT_NEAR(statistics->GetMean(Statistics::LOOKUPS) * double(pixels),
    double(scene.Mapper->GetNumberOfLookups()), 0.5);
  EXPECT_GE(statistics->GetMinimum(Statistics::CELLS), 1.0);
  EXPECT_GT(statistics->GetMaximum(Statistics::CELLS), statistics->GetMean(Statistics::CELLS));
  EXPECT_GT(statistics->GetMaximum(Statistics::ERROR_BOUND), 0.0);
  EXPECT_LE(statistics->GetMaximum(Statistics::ERROR_BOUND), scene.Mapper->GetErrorTolerance());
  EXPECT_EQ(statistics->GetNumberOfPixels(Statistics::TRUE_ERROR), 0);
  EXPECT_EQ(statistics->GetGPUMemoryBytes(), scene.Mapper->GetGPUMemoryBytes());
}

// With opaque geometry inside and scalars at points or in cells: the error of the frame is below
// the bound that the frame gives, but for rounding.
TEST(Accuracy, TrueErrorsAreBelowTheBound)
{
  for (const int level : Levels)
  {
    Scene scene(jitteredLattice(16, 0.15, 5, sineField()));
    setBumpyFunctions(scene.property());
    scene.property()->SetScalarOpacityUnitDistance(0.05);
    scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.3, { 1.0, 0.8, 0.2 }));
    scene.Mapper->SetAccuracyLevel(level);
    scene.Mapper->CollectDiagnosticsOn();
    scene.Window->Render();
    ASSERT_TRUE(scene.Mapper->CompareWithGroundTruth(scene.Volume));
    Statistics* statistics = scene.Mapper->GetLastFrameStatistics();
    EXPECT_EQ(statistics->GetNumberOfPixels(Statistics::TRUE_ERROR),
      statistics->GetNumberOfPixels(Statistics::CELLS));
    // A pixel or two of the silhouette, of the mesh or of the ball, may be another pixel's.
    EXPECT_LE(statistics->GetPercentile(Statistics::TRUE_ERROR, 99.5),
      statistics->GetMaximum(Statistics::ERROR_BOUND) + 1e-4);
    EXPECT_LE(statistics->GetMean(Statistics::TRUE_ERROR),
      statistics->GetMean(Statistics::ERROR_BOUND) + 1e-5);
    std::cout << "[ MEASURED ] " << scene.Mapper->GetAccuracyLevelAsString() << ": true error mean "
              << statistics->GetMean(Statistics::TRUE_ERROR) << ", 99.9 % "
              << statistics->GetPercentile(Statistics::TRUE_ERROR, 99.9) << ", max "
              << statistics->GetMaximum(Statistics::TRUE_ERROR) << "; bound mean "
              << statistics->GetMean(Statistics::ERROR_BOUND) << ", max "
              << statistics->GetMaximum(Statistics::ERROR_BOUND) << '\n';
  }
}

TEST(Accuracy, NothingToCompareIsAnError)
{
  Scene scene(noise());
  vtkNew<vtkFloatArray> pixels;
  ErrorWatch errors(scene.Mapper);
  EXPECT_FALSE(scene.Mapper->RenderGroundTruth(scene.Volume, pixels));
  ASSERT_EQ(errors.Errors.size(), 1u);
  EXPECT_NE(errors.Errors[0].find("render the window first"), std::string::npos);
  scene.Mapper->CollectDiagnosticsOff();
  scene.Window->Render();
  EXPECT_TRUE(scene.Mapper->RenderGroundTruth(scene.Volume, pixels));
  EXPECT_EQ(pixels->GetNumberOfTuples(), SceneSize * SceneSize);
  const auto pictureOf = [](vtkFloatArray* of)
  { return Image::fromFloats(SceneSize, SceneSize, of->GetPointer(0)); };
  vtkNew<vtkFloatArray> rough;
  EXPECT_TRUE(scene.Mapper->RenderGroundTruth(scene.Volume, rough, 1e-2));
  const Difference apart = compare(pictureOf(rough), pictureOf(pixels));
  EXPECT_LE(apart.Max, 1e-2) << apart.text();
  EXPECT_GT(apart.Max, 1e-5) << apart.text();
  EXPECT_FALSE(scene.Mapper->CompareWithGroundTruth(scene.Volume));
  ASSERT_EQ(errors.Errors.size(), 2u);
  EXPECT_NE(errors.Errors[1].find("CollectDiagnostics"), std::string::npos);
  for (const double tolerance : { 0.0, -1.0, 1.5, std::nan("") })
  {
    EXPECT_FALSE(scene.Mapper->RenderGroundTruth(scene.Volume, pixels, tolerance));
    EXPECT_NE(errors.Errors.back().find("tolerance is greater than 0"), std::string::npos);
  }
  EXPECT_EQ(errors.Errors.size(), 6u);
  // The hierarchy that the reference added is uploaded, and the next frame is the same.
  const Image before = scene.frame();
  scene.Window->Render();
  EXPECT_EQ(compare(scene.frame(), before).Max, 0.0);
}
} // namespace
