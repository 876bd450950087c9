// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The accuracy level Sampled: the GL against the CPU, which marches the ray of each pixel by
// samples, too, and both against the exact picture as the distance shrinks.
#include "SampledScene.h"
#include "ScenePage.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPlane.h"
#include "vtkTable.h"

#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch::testing;

// Of the frame before, pixel by pixel, by the CPU in double precision at the level of the frame.
Image tracedPicture(StructuredScene& scene)
{
  const int* size = scene.Renderer->GetSize();
  Image image(size[0], size[1]);
  vtkNew<vtkTable> cells;
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      EXPECT_TRUE(scene.Mapper->TraceRay(
        scene.Volume, x, y, vtkTetMarchSmartVolumeMapper::TRACE_DOUBLE, cells));
      vtkDataArray* color = cells->GetFieldData()->GetArray("Color");
      for (int c = 0; c < 4; ++c)
      {
        image.pixel(x, y)[c] = static_cast<float>(color->GetComponent(0, c));
      }
    }
  }
  return image;
}

void expectSampledParity(StructuredScene& scene, const std::string& what)
{
  SCOPED_TRACE(what);
  const Image drawn = scene.render();
  expectCounters(scene);
  const Image traced = tracedPicture(scene);
  const Difference difference = compare(drawn, traced);
  std::cout << "[ MEASURED ] " << what << ": " << difference.text() << '\n';
  EXPECT_GT(compare(traced, Image(traced.Width, traced.Height)).Max, 0.05) << "nothing is seen";
  EXPECT_LE(difference.Max, 2.0 / 255.0);
  EXPECT_LE(difference.Rms, 0.3 / 255.0);
  keepScenePage(scene.Window);
}

TEST(SampledParity, AllKindsOfValues)
{
  for (const LatticeValues values : AllLatticeValues)
  {
    SampledScene scene(imageOf(sineField()));
    scene.draw(values);
    expectSampledParity(scene, nameOf(values));
    scene.Mapper->UseJitteringOn();
    expectSampledParity(scene, std::string(nameOf(values)) + ", jittered");
  }
}

TEST(SampledParity, RectilinearGridsAndTurnedImages)
{
  SampledScene uneven(rectilinearOf(sineField()));
  expectSampledParity(uneven, "rectilinear");
  for (const ImagePlace& place : imagePlaces())
  {
    const auto image = imageOf(sineField(), place);
    SampledScene scene(image, 0.05 * image->GetLength());
    scene.lookAtAll();
    expectSampledParity(scene, place.Name);
  }
}

TEST(SampledParity, CutsAndCamerasInside)
{
  SampledScene inside(imageOf(sineField()));
  lookFromInside(inside.camera());
  expectSampledParity(inside, "inside");
  SampledScene clipped(imageOf(sineField()));
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.5, 0.45, 0.5);
  plane->SetNormal(1.0, 0.3, -0.2);
  clipped.Mapper->AddClippingPlane(plane);
  expectSampledParity(clipped, "clipped");
  SampledScene cropped(imageOf(sineField()));
  cropped.Mapper->CroppingOn();
  cropped.Mapper->SetCroppingRegionPlanes(0.2, 0.7, 0.3, 0.8, 0.25, 0.6);
  cropped.Mapper->SetCroppingRegionFlagsToInvertedCross();
  expectSampledParity(cropped, "cropped");
  SampledScene leaping(imageOf(sineField(), unitCube(24)), 1.0 / 30);
  setTwoPeaks(leaping.property());
  expectSampledParity(leaping, "leaps");
}

// The first sample stands for the step in front of it: what a sum of rectangles is off by falls
// with the distance. Halved four times it must be a tenth at most.
TEST(SampledParity, ConvergesToTheExactPicture)
{
  const auto image = imageOf(sineField(), unitCube(12));
  SampledScene scene(image);
  scene.property()->SetScalarOpacityUnitDistance(0.5); // else rays end early
  double first = 0;
  double last = 1;
  for (const int samples : { 1, 2, 4, 8, 16 })
  {
    scene.Mapper->SetSampleDistance(static_cast<float>(1.0 / 12 / samples));
    const Image drawn = scene.render();
    const Difference difference = compare(drawn, scene.truth());
    std::cout << "[ MEASURED ] " << samples << " samples a voxel: " << difference.text() << '\n';
    EXPECT_LT(difference.Rms, 0.75 * last) << samples;
    first = samples == 1 ? difference.Rms : first;
    last = difference.Rms;
  }
  EXPECT_LT(last, 0.1 * first);
}

std::vector<float> redOf(const Image& image)
{
  std::vector<float> red;
  for (std::size_t i = 0; i < image.Rgba.size(); i += 4)
  {
    red.push_back(image.Rgba[i]);
  }
  return red;
}

// Of a picture with its neighbours to the right, of what it differs from another by.
double correlationOfErrors(const Image& image, const Image& truth)
{
  const std::vector<float> red = redOf(image);
  const std::vector<float> exact = redOf(truth);
  double products = 0;
  double squares = 0;
  for (int y = 0; y < image.Height; ++y)
  {
    for (int x = 0; x + 1 < image.Width; ++x)
    {
      const std::size_t i = std::size_t(y) * image.Width + x;
      const double a = double(red[i]) - double(exact[i]);
      products += a * (double(red[i + 1]) - double(exact[i + 1]));
      squares += a * a;
    }
  }
  return products / squares;
}

double meanError(const Image& image, const Image& truth)
{
  double sum = 0;
  for (std::size_t i = 0; i < image.Rgba.size(); ++i)
  {
    sum += double(image.Rgba[i]) - double(truth.Rgba[i]);
  }
  return sum / double(image.Rgba.size());
}

// Rings of samples that meet a peak together become grain, of which the eye takes the mean. What is
// left of the mean's error is of the order of samples, since a mean of products is not their
// product.
TEST(SampledParity, JitterLeavesNeitherBiasNorPattern)
{
  StructuredScene scene(imageOf(sineField(), unitCube(12)), 128, 128);
  setTwoPeaks(scene.property());
  scene.property()->SetScalarOpacityUnitDistance(2.0); // else rays end early, which is a bias
  scene.Mapper->InteractiveAdjustSampleDistancesOff();
  scene.Mapper->AutoAdjustSampleDistancesOff();
  scene.render();
  const Image exact = scene.truth();
  scene.Mapper->SetAccuracyLevelToSampled();
  for (const int samples : { 1, 2, 4 })
  {
    SCOPED_TRACE(samples);
    scene.Mapper->SetSampleDistance(static_cast<float>(1.0 / 12 / samples));
    scene.Mapper->UseJitteringOff();
    const Image even = scene.render();
    scene.Mapper->UseJitteringOn();
    const Image jittered = scene.render();
    EXPECT_EQ(jittered.Rgba, scene.render().Rgba) << "another frame has another noise";
    const double evenPattern = correlationOfErrors(even, exact);
    const double pattern = correlationOfErrors(jittered, exact);
    const double evenBias = std::abs(meanError(even, exact));
    const double bias = std::abs(meanError(jittered, exact));
    std::cout << "[ MEASURED ] " << samples
              << " samples a voxel: correlation of neighbours' errors " << evenPattern
              << ", jittered " << pattern << "; mean error " << 255 * evenBias << "/255, jittered "
              << 255 * bias << "/255\n";
    EXPECT_GT(evenPattern, 0.4);
    EXPECT_LT(std::abs(pattern), 0.2);
    EXPECT_LT(3 * bias, evenBias);
    EXPECT_LT(bias, 0.05 / 255 / samples);
  }
}
} // namespace
