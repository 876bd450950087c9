// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CpuReference.h"

#include "FreshFrame.h"
#include "MapperFrameInput.h"
#include "ScenePage.h"

#include <gtest/gtest.h>
#include <iostream>

namespace tetmarch::testing
{
namespace
{
std::unique_ptr<FrameScene> marchedBy(
  const FreshFrame& frame, Scene& scene, const std::vector<float>& depths)
{
  const AccuracyLevel level = levelOf(
    static_cast<Accuracy>(scene.Mapper->GetAccuracyLevel()), scene.Mapper->GetErrorTolerance());
  const int* size = scene.Renderer->GetSize();
  std::unique_ptr<FrameScene> made = frame.at(level, size[0], size[1]);
  made->scene().WindowDepths = depths.empty() ? nullptr : depths.data();
  return made;
}

Difference compareInside(
  const char* what, const Image& drawn, const Image& reference, const Mask& inside)
{
  const Difference difference = compare(drawn, reference, inside);
  EXPECT_LE(difference.Max, 2.0 / 255.0) << what << ": " << difference.text();
  EXPECT_LE(difference.Rms, 0.3 / 255.0) << what << ": " << difference.text();
  std::cout << "[ MEASURED ] inside, " << what << ": " << difference.text() << '\n';
  return difference;
}

void expectCounters(const vtkTetMarchVolumeMapper* mapper)
{
  // The rasteriser's rounding: searched for.
  EXPECT_LE(mapper->GetNumberOfRefusedEntries(), 20);
  EXPECT_EQ(mapper->GetNumberOfLostRays(), 0);
  EXPECT_EQ(mapper->GetNumberOfGuardHits(), 0);
  EXPECT_GT(mapper->GetNumberOfRays(), 100);
  EXPECT_GE(mapper->GetNumberOfCrossedCells(), mapper->GetNumberOfRays());
  EXPECT_GT(mapper->GetNumberOfLookups(), 100);
}

void expectAgreement(Scene& scene, const Image& drawn, const std::vector<float>& depths)
{
  expectCounters(scene.Mapper);
  const ReferencePicture reference = referenceOf(scene, depths);
  const Regions regions = regionsOf(scene, depths);
  const Difference inside = compareInside("double", drawn, reference.Picture, regions.Inside);
  EXPECT_GT(inside.Pixels, 400u);
  compareInside(
    "float", drawn, referenceOf(scene, depths, Precision::Float).Picture, regions.Inside);

  const Image nothing(drawn.Width, drawn.Height);
  EXPECT_EQ(compare(drawn, nothing, regions.Outside, 0.0).Over, 0u) << "something outside";
  const Difference rim = compare(drawn, reference.Picture, regions.Rim);
  EXPECT_LE(50 * rim.Over, rim.Pixels) << "rim: " << rim.text();
  std::cout << "[ MEASURED ] rim: " << rim.text() << "; rays " << scene.Mapper->GetNumberOfRays()
            << " (reference " << reference.Counters.Rays << "), cells "
            << scene.Mapper->GetNumberOfCrossedCells() << " (reference " << reference.Counters.Cells
            << ")\n";
  keepScenePage(scene.Window);
}
} // namespace

ReferencePicture referenceOf(
  Scene& scene, const std::vector<float>& depths, Precision precision, LightAt light)
{
  const FreshFrame frame(
    frameInputOf(scene.Mapper.Get(), scene.Data, scene.Renderer, scene.Volume));
  const auto made = marchedBy(frame, scene, depths);
  made->scene().Light = light;
  const ReferenceImage image =
    precision == Precision::Double ? made->render<double>() : made->render<float>();
  const ReferenceScene& drawn = made->scene();
  return { Image::fromFloats(drawn.Width, drawn.Height, image.Pixels.data()), image.ErrorBounds,
    image.Counters };
}

Regions regionsOf(Scene& scene, const std::vector<float>& depths)
{
  // Thin fog shows every chord, and nothing ends early in it.
  vtkNew<vtkVolume> shown;
  shown->SetUserMatrix(scene.Volume->GetMatrix());
  vtkVolumeProperty* fog = shown->GetProperty();
  setPlainFunctions(fog, { 1.0, 1.0, 1.0 }, 0.01);
  fog->GetRGBTransferFunction()->SetNanColorRGBA(1.0, 1.0, 1.0, 0.01);
  fog->SetScalarOpacityUnitDistance(scene.Data->GetLength());
  FrameInput input = frameInputOf(scene.Mapper.Get(), scene.Data, scene.Renderer, shown);
  input.Drawn.Vector = { VectorMode::Component, 0 };
  input.Drawn.Blend = {};
  input.Effects = {};
  const FreshFrame frame(input);
  const auto made = marchedBy(frame, scene, depths);
  made->scene().Hidden = nullptr;
  const ReferenceScene& drawn = made->scene();
  const Image seen =
    Image::fromFloats(drawn.Width, drawn.Height, made->render<double>().Pixels.data());

  Regions regions;
  for (int y = 0; y < seen.Height; ++y)
  {
    for (int x = 0; x < seen.Width; ++x)
    {
      bool all = true;
      bool any = false;
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, seen.Height - 1); ++v)
      {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, seen.Width - 1); ++u)
        {
          const bool covered = seen.pixel(u, v)[3] > 0.0f;
          all = all && covered;
          any = any || covered;
        }
      }
      regions.Inside.push_back(all);
      regions.Outside.push_back(!any);
      regions.Rim.push_back(any && !all);
    }
  }
  return regions;
}

void expectParity(Scene& scene, const std::vector<float>& depths)
{
  const Image drawn = scene.render();
  expectAgreement(scene, drawn, depths);
}

void expectParityWithOpaque(Scene& scene)
{
  const Image drawn = scene.render();
  expectAgreement(scene, drawn, scene.windowDepths());
}

void expectLightAlongRays(Scene& scene, const Image& drawn, const Image& without)
{
  const Difference difference = compare(drawn,
    referenceOf(scene, {}, Precision::Double, LightAt::Faces).Picture, regionsOf(scene).Inside);
  std::cout << "[ MEASURED ] " << difference.text() << '\n';
  EXPECT_GT(difference.Pixels, 200u);
  EXPECT_LE(difference.Rms, 1.5 / 255.0);
  EXPECT_GT(compare(drawn, without).Max, 0.02);
  keepScenePage(scene.Window);
}
} // namespace tetmarch::testing
