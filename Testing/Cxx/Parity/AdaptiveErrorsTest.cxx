// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What is told of pictures with interpolated pixels (PixelTolerance): their errors, and where they
// are.
#include "SmartScene.h"

#include "vtkLookupTable.h"
#include "vtkTetMarchFrameStatistics.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;
using Statistics = vtkTetMarchFrameStatistics;

constexpr int Side = 83; // not a multiple of the first grid's spacing
constexpr double Careless = 0.2;

template <typename AnyScene>
Statistics* drawCounted(AnyScene& scene, double tolerance)
{
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  scene.Mapper->CollectDiagnosticsOn();
  scene.Mapper->SetPixelTolerance(tolerance);
  scene.Window->Render();
  return scene.Mapper->GetLastFrameStatistics();
}

// The largest error of a colour of the window, which is black behind the volume.
template <typename AnyScene>
double errorOfWindow(AnyScene& scene)
{
  const Image shown = framePictureOf(scene.Window);
  vtkNew<vtkFloatArray> truth;
  EXPECT_TRUE(scene.Mapper->RenderGroundTruth(scene.Volume, truth));
  double most = 0;
  for (std::size_t i = 0; i < shown.Rgba.size(); ++i)
  {
    const double error = shown.Rgba[i] - truth->GetValue(static_cast<vtkIdType>(i));
    most = i % 4 == 3 ? most : std::max(most, std::abs(error));
  }
  return most;
}

int withoutBound(const Statistics* statistics)
{
  const auto count = statistics->GetNumberOfPixels(Statistics::ERROR_BOUND);
  int without = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double percent = 100.0 * (double(i) + 0.5) / double(count);
    without += statistics->GetPercentile(Statistics::ERROR_BOUND, percent) == 1.0;
  }
  return without;
}

bool isGrey(const float* rgb)
{
  return std::all_of(rgb, rgb + 3, [](float c) { return std::abs(c - 0.5f) < 0.6f / 255; });
}

template <typename AnyScene>
void expectErrorsOfThePicture(AnyScene& scene)
{
  for (const double tolerance : { Careless, 0.0 })
  {
    Statistics* statistics = drawCounted(scene, tolerance);
    EXPECT_EQ(statistics->GetUsedPixelTolerance(), tolerance);
    ASSERT_TRUE(scene.Mapper->CompareWithGroundTruth(scene.Volume));
    const double error = statistics->GetMaximum(Statistics::TRUE_ERROR);
    EXPECT_NEAR(error, errorOfWindow(scene), 0.51 / 255);
    EXPECT_EQ(error > 2.0 / 255, tolerance > 0) << error;
    EXPECT_EQ(statistics->GetMaximum(Statistics::ERROR_BOUND) == 1.0, tolerance > 0);
  }
}

// The colours before they are rounded.
template <typename AnyScene>
Image colorsOf(AnyScene& scene, double tolerance)
{
  drawCounted(scene, tolerance);
  vtkNew<vtkFloatArray> pixels;
  scene.Mapper->GetDiagnosticPixels(pixels);
  return Image::fromFloats(Side, Side, pixels->GetPointer(0));
}

// Those of the first grid have a ray. The others are grey unless they had one, and then their
// colour is that of the ray, in 16 bits.
template <typename AnyScene>
void expectInterpolatedPixelsInGrey(AnyScene& scene)
{
  const Image full = colorsOf(scene, 0.0);
  const Image drawn = colorsOf(scene, Careless);
  Statistics* statistics = scene.Mapper->GetLastFrameStatistics();
  const auto rays = statistics->GetNumberOfTracedRays();
  const int without = withoutBound(statistics);
  const auto count = statistics->GetNumberOfPixels(Statistics::ERROR_BOUND);
  EXPECT_GT(without, count / 2);
  EXPECT_LT(without, count);
  scene.Mapper->CollectDiagnosticsOff();
  scene.Mapper->SetViewModeToErrorBound();
  const Image view = (scene.Window->Render(), framePictureOf(scene.Window));
  EXPECT_EQ(statistics->GetNumberOfTracedRays(), rays);
  int grey = 0;
  int seen = 0;
  for (int i = 0; i < Side * Side; ++i)
  {
    const float* rgb = &view.Rgba[4 * std::size_t(i)];
    seen += *std::max_element(rgb, rgb + 3) > 0;
    grey += isGrey(rgb);
    for (int k = 0; k < 4 && !isGrey(rgb); ++k)
    {
      ASSERT_NEAR(drawn.Rgba[4 * i + k], full.Rgba[4 * i + k], 2e-5f)
        << i % Side << ' ' << i / Side;
    }
    EXPECT_FALSE(isGrey(rgb) && i % Side % 8 == 0 && i / Side % 8 == 0) << i;
  }
  EXPECT_EQ(seen, count);
  EXPECT_EQ(grey, without);
  EXPECT_LE(seen - grey, rays);
  EXPECT_LT(scene.Mapper->GetViewLookupTable()->GetTableRange()[1], 0.5) << "of those with a ray";
  scene.Mapper->SetViewModeToCells();
  const Image cells = (scene.Window->Render(), framePictureOf(scene.Window));
  EXPECT_EQ(statistics->GetUsedPixelTolerance(), 0.0);
  for (int i = 0; i < Side * Side; ++i)
  {
    EXPECT_FALSE(isGrey(&cells.Rgba[4 * std::size_t(i)])) << i;
  }
}

TEST(AdaptiveErrors, OfMeshes)
{
  Scene scene(jitteredLattice(5, 0.15, 1, sineField()), Side, Side);
  expectErrorsOfThePicture(scene);
  expectInterpolatedPixelsInGrey(scene);
}

TEST(AdaptiveErrors, OfImages)
{
  SmartScene scene(imageOf(sineField()), Side, Side);
  expectErrorsOfThePicture(scene);
  expectInterpolatedPixelsInGrey(scene);
}
} // namespace
