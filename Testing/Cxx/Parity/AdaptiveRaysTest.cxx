// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Pictures with rays where they are needed (PixelTolerance), beside those with a ray a pixel.
#include "BlendScene.h"
#include "CutScene.h"
#include "SmartScene.h"

#include "vtkActor.h"
#include "vtkTetMarchFrameStatistics.h"

#include <functional>
#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 250; // not a multiple of the first grid's spacing
constexpr double Tolerance = 4.0 / 255.0;

template <typename AnyScene>
Image drawWith(AnyScene& scene, double tolerance)
{
  scene.Mapper->CollectDiagnosticsOff();
  scene.Mapper->SetPixelTolerance(tolerance);
  scene.Window->Render();
  return framePictureOf(scene.Window);
}

template <typename AnyScene>
double shareOfRays(AnyScene& scene, double tolerance)
{
  scene.Mapper->CollectDiagnosticsOn();
  scene.Mapper->SetPixelTolerance(tolerance);
  scene.Window->Render();
  scene.Mapper->CollectDiagnosticsOff();
  const int* size = scene.Window->GetSize();
  return double(scene.Mapper->GetLastFrameStatistics()->GetNumberOfTracedRays()) /
         (size[0] * size[1]);
}

// Without a tolerance to speak of, only pixels that are as their neighbours predict are
// interpolated. With one, the picture is near, and takes fewer rays.
template <typename AnyScene>
void expectNear(AnyScene& scene, double mostRms)
{
  const Image full = drawWith(scene, 0.0);
  const Difference strict = compare(full, drawWith(scene, 1e-6), {}, 0.0, Channels::Rgb);
  EXPECT_LE(strict.Max, 1.01 / 255.0) << strict.text();
  const Image adaptive = drawWith(scene, Tolerance);
  const Difference near = compare(full, adaptive, {}, Tolerance, Channels::Rgb);
  const double share = shareOfRays(scene, Tolerance);
  std::cout << "[ MEASURED ] " << near.text() << ", rays " << share << '\n';
  EXPECT_LT(near.Rms, mostRms);
  EXPECT_LT(share, 0.75);
  EXPECT_GT(share, 1.0 / 64);
  EXPECT_GT(shareOfRays(scene, 1e-6), share);
  EXPECT_EQ(compare(adaptive, drawWith(scene, Tolerance)).Max, 0.0) << "the same each time";
  EXPECT_EQ(compare(full, drawWith(scene, 0.0)).Max, 0.0);
}

struct Case
{
  const char* Name;
  std::function<void(BlendScene&)> Arrange;
};

void addBall(BlendScene& scene)
{
  scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 0.8, 0.2 }));
}

const Case Cases[] = {
  { "Composite", [](BlendScene&) {} },
  { "Maximum", [](BlendScene& s) { s.Mapper->SetBlendModeToMaximumIntensity(); } },
  { "Average", [](BlendScene& s) { s.Mapper->SetBlendModeToAverageIntensity(); } },
  { "Isosurfaces", [](BlendScene& s) { s.Mapper->SetBlendModeToIsoSurface(); } },
  { "Shadows", [](BlendScene& s) { s.Mapper->SetShadowMethodToAtVertices(); } },
  { "Cells", [](BlendScene& s) { s.drawCellScalars(); } },
  { "Clipped", [](BlendScene& s) { clipObliquely(s); } },
  { "Cropped", [](BlendScene& s) { crop(s, VTK_CROP_FENCE); } },
  { "Opaque", addBall },
  { "Inside", [](BlendScene& s) { lookFromInside(s.camera()); } },
  { "Tiles", [](BlendScene& s) { s.Mapper->SetMaxDrawTimeInSeconds(1e-9); } },
  { "Viewport", [](BlendScene& s) { s.Renderer->SetViewport(0.13, 0.07, 0.9, 0.85); } },
};

class AdaptiveRays : public testing::TestWithParam<Case>
{
};

TEST_P(AdaptiveRays, AreNearTheFullPicture)
{
  BlendScene scene(latticeWithHole(4, 0.15, 1, sineField()), Side, Side);
  GetParam().Arrange(scene);
  expectNear(scene, 0.004);
}

INSTANTIATE_TEST_SUITE_P(
  Scenes, AdaptiveRays, testing::ValuesIn(Cases), [](const auto& i) { return i.param.Name; });

TEST(AdaptiveRaysOfImages, AreNearTheFullPicture)
{
  SmartScene scene(imageOf(sineField()), Side, Side);
  expectNear(scene, 0.004);
  scene.property()->ShadeOn();
  expectNear(scene, 0.004);
}

// A box of the unit cube's height and depth, seen along its depth.
Grid slab(double begin, double width)
{
  Grid grid = jitteredLattice(2, 0.0, 1, constantField(0.5));
  vtkPoints* points = grid->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    points->SetPoint(i, begin + width * p[0], p[1], p[2]);
  }
  return grid;
}

// One pixel wide, wherever it is between the rays of the first grid, upright and level.
TEST(AdaptiveRaysOfThinParts, AreFoundAtEachPhase)
{
  const double pixel = 1.0 / SceneSize;
  Scene scene(slab(0.0, 1.0));
  setPlainFunctions(scene.property(), { 1.0, 0.6, 0.2 }, 1.0);
  for (const double width : { 1.0, 0.5, 2.0 })
  {
    for (int phase = 0; phase < 9; ++phase)
    {
      scene.Mapper->SetInputData(slab((70 + phase + 0.25) * pixel, width * pixel));
      lookDownZ(scene.camera(), 0.5);
      for (const double roll : { 0.0, 90.0, 30.0 })
      {
        scene.camera()->Roll(roll);
        const Image full = drawWith(scene, 0.0);
        const Difference found = compare(full, drawWith(scene, Tolerance));
        EXPECT_LE(found.Max, 1.01 / 255.0) << width << ' ' << phase << ' ' << roll << found.text();
        EXPECT_GT(compare(full, Image(SceneSize, SceneSize), {}, 0, Channels::Rgb).Max, 0.05);
      }
    }
  }
}

// The second view mirrors the first one, so that the slab fills the same part of the picture.
TEST(AdaptiveRaysOfThinParts, AreFoundWhereTheCameraHasTurned)
{
  Scene scene(slab(0.496, 0.008));
  setPlainFunctions(scene.property(), { 1.0, 0.6, 0.2 }, 1.0);
  lookDownZ(scene.camera(), 0.5);
  for (const double roll : { 30.0, -60.0, 60.0 })
  {
    scene.camera()->Roll(roll);
    const Image adaptive = drawWith(scene, Tolerance);
    const Difference found = compare(drawWith(scene, 0.0), adaptive);
    EXPECT_LE(found.Max, 1.01 / 255.0) << roll << found.text();
    drawWith(scene, Tolerance);
  }
}

// Of an image, one voxel wide, wherever it is between the rays of the first grid.
TEST(AdaptiveRaysOfThinParts, OfImages)
{
  for (const int size : { SceneSize / 2, SceneSize / 4 }) // voxels of 2 and 4 pixels
  {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(size + 1, size + 1, 5);
    image->SetSpacing(1.0 / size, 1.0 / size, 0.1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    auto* values = static_cast<unsigned char*>(image->GetScalarPointer());
    std::fill(values, values + image->GetNumberOfPoints(), static_cast<unsigned char>(0));
    for (int i = 5; i + 6 < size; i += 6) // a diagonal of dots
    {
      values[(size + 1) * ((size + 1) * 2 + i) + i] = 255;
    }
    SmartScene scene(image);
    lookDownZ(scene.Renderer->GetActiveCamera(), 0.5);
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(0.0, 0.0);
    opacity->AddPoint(255.0, 1.0);
    scene.property()->SetScalarOpacity(opacity);
    scene.property()->SetScalarOpacityUnitDistance(0.05);
    const Image full = drawWith(scene, 0.0);
    const Difference found = compare(full, drawWith(scene, Tolerance), {}, 0.0, Channels::Rgb);
    EXPECT_LE(found.Max, 3.0 * Tolerance) << size << found.text();
    EXPECT_GT(compare(full, Image(SceneSize, SceneSize), {}, 0, Channels::Rgb).Max, 0.3);
  }
}

// Rays end at a plate as thin as a pixel in front of the volume.
TEST(AdaptiveRaysOfThinParts, BehindThinOpaqueParts)
{
  Scene scene(jitteredLattice(3, 0.1, 1, constantField(0.5)));
  setPlainFunctions(scene.property(), { 1.0, 0.6, 0.2 }, 0.9);
  lookDownZ(scene.camera(), 0.5);
  auto plate = makePlane(0.5, 0.0, { 0.1, 0.1, 0.1 });
  plate->SetScale(1.2 / SceneSize, 1.0, 1.0);
  scene.Renderer->AddActor(plate);
  for (int phase = 0; phase < 9; ++phase)
  {
    plate->SetPosition((70.5 + phase) / SceneSize, 0.0, 0.25);
    const Image full = drawWith(scene, 0.0);
    const Difference found = compare(full, drawWith(scene, Tolerance));
    EXPECT_LE(found.Max, 2.01 / 255.0) << phase << found.text();
  }
}

TEST(AdaptiveRaysOfWindows, OfAnySize)
{
  BlendScene scene(latticeWithHole(3, 0.15, 1, sineField()), 1, 1);
  for (const auto& size : { std::array<int, 2>{ { 1, 1 } }, { { 2, 1 } }, { { 3, 17 } },
         { { 8, 8 } }, { { 9, 9 } }, { { 16, 5 } }, { { 64, 65 } } })
  {
    scene.Window->SetSize(size[0], size[1]);
    const Difference found = compare(drawWith(scene, 0.0), drawWith(scene, 1e-6));
    EXPECT_LE(found.Max, 1.01 / 255.0) << size[0] << 'x' << size[1] << found.text();
  }
}

TEST(AdaptiveRaysOfWindows, ByComputeAsByFragments)
{
  BlendScene scene(latticeWithHole(4, 0.15, 1, sineField()), Side, Side);
  scene.Mapper->SetShaderStageToFragment();
  const Image byFragments = drawWith(scene, Tolerance);
  scene.Mapper->SetShaderStageToCompute();
  const Image byCompute = drawWith(scene, Tolerance);
  if (scene.Mapper->GetUsedShaderStage() != Mapper::COMPUTE_STAGE)
  {
    GTEST_SKIP() << "this GL has no compute shaders";
  }
  EXPECT_EQ(byFragments.Rgba, byCompute.Rgba);
}

TEST(AdaptiveRaysOfWindows, TakeRoomOnlyWhileTheyAreUsed)
{
  BlendScene scene(latticeWithHole(3, 0.15, 1, sineField()), Side, Side);
  scene.Mapper->SetShaderStageToFragment(); // a compute shader's picture takes room, too
  drawWith(scene, 0.0);
  const vtkTypeInt64 before = scene.Mapper->GetGPUMemoryBytes();
  drawWith(scene, Tolerance);
  EXPECT_GT(scene.Mapper->GetGPUMemoryBytes(), before);
  drawWith(scene, 0.0);
  EXPECT_EQ(scene.Mapper->GetGPUMemoryBytes(), before);
  EXPECT_GT(shareOfRays(scene, Tolerance), 0.0);
  EXPECT_EQ(shareOfRays(scene, 0.0), 0.0) << "not counted";
}

// With fewer pixels the adaptive picture is enlarged.
TEST(AdaptiveRaysOfWindows, WithFewerPixels)
{
  BlendScene scene(latticeWithHole(3, 0.15, 1, sineField()), Side, Side);
  scene.Mapper->AutoAdjustSampleDistancesOff();
  scene.Mapper->SetImageSampleDistance(2.0);
  const Difference near =
    compare(drawWith(scene, 0.0), drawWith(scene, 1e-6), {}, 0.0, Channels::Rgb);
  EXPECT_LE(near.Max, 1.01 / 255.0) << near.text();
}
} // namespace
