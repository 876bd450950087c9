// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Passes that make another image of the whole picture, which they have drawn into a framebuffer of
// their own, larger than the window or in another format: what comes out is what they would make of
// the picture without them.
#include "PassScene.h"

#include "vtkGaussianBlurPass.h"
#include "vtkOpenGLFXAAPass.h"
#include "vtkRenderStepsPass.h"
#include "vtkToneMappingPass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace
{
using namespace tetmarch::testing;

class ImagePass : public PassScene
{
};

float luminosity(const float* rgb) { return 0.299f * rgb[0] + 0.587f * rgb[1] + 0.114f * rgb[2]; }

// FXAA leaves a pixel as it is that differs from its four neighbours by less than a sixteenth.
TEST_F(ImagePass, SmoothEdgesOfAll)
{
  this->addBall();
  const Image plain = this->frame();
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkOpenGLFXAAPass> pass;
  pass->SetDelegatePass(steps);
  const Image smooth = this->frame(pass);
  Mask flat;
  for (int y = 0; y < Side; ++y)
  {
    for (int x = 0; x < Side; ++x)
    {
      float least = 1.0f, most = 0.0f;
      for (const auto& [u, v] :
        { std::pair(0, 0), std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1) })
      {
        const float l =
          luminosity(plain.pixel(std::clamp(x + u, 0, Side - 1), std::clamp(y + v, 0, Side - 1)));
        least = std::min(least, l);
        most = std::max(most, l);
      }
      flat.push_back(most - least < 0.9f / 16.0f);
    }
  }
  const Difference flatOnes = compare(smooth, plain, flat, 0.0, Channels::Rgb);
  EXPECT_EQ(flatOnes.Max, 0.0) << flatOnes.text();
  EXPECT_GT(flatOnes.Pixels, std::size_t(Side * Side / 2));
  const Difference edges = compare(smooth, plain, {}, 2.0 / 255.0, Channels::Rgb);
  EXPECT_GT(edges.Over, 100u) << edges.text();
  pass->ReleaseGraphicsResources(this->Shown.Window);
}

TEST_F(ImagePass, ToneMapping)
{
  this->addBall();
  const Image plain = this->frame();
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkToneMappingPass> pass;
  pass->SetDelegatePass(steps);
  pass->SetToneMappingType(vtkToneMappingPass::Reinhard);
  // Reinhard et al. 2002: c / (1 + c) in linear colours; VTK mixes it in by the opacity of the
  // framebuffer.
  const Image toned = this->frame(pass);
  Image expected(Side, Side);
  for (std::size_t i = 0; i < expected.Rgba.size(); ++i)
  {
    const float linear = std::pow(plain.Rgba[i], 2.2f);
    const float mapped = std::pow(linear / (linear + 1.0f), 1.0f / 2.2f);
    expected.Rgba[i] = plain.Rgba[i] + (mapped - plain.Rgba[i]) * plain.Rgba[i | 3];
  }
  EXPECT_GT(compare(toned, plain, {}, 0.0, Channels::Rgb).Max, 0.1);
  expectSame(toned, expected, 2.0 / 255.0);
  pass->ReleaseGraphicsResources(this->Shown.Window);
}

// Of an image that is 1 pixel as wide and high as a texel.
std::array<float, 4> mixedAt(const Image& image, double x, double y)
{
  const int right = image.Width - 1, top = image.Height - 1;
  const int i = static_cast<int>(std::floor(x - 0.5)), j = static_cast<int>(std::floor(y - 0.5));
  const double u = x - 0.5 - i, v = y - 0.5 - j;
  std::array<float, 4> mixed{};
  for (const auto& [di, dj, share] : { std::tuple(0, 0, (1 - u) * (1 - v)),
         std::tuple(1, 0, u * (1 - v)), std::tuple(0, 1, (1 - u) * v), std::tuple(1, 1, u * v) })
  {
    const float* texel = image.pixel(std::clamp(i + di, 0, right), std::clamp(j + dj, 0, top));
    for (int c = 0; c < 4; ++c)
    {
      mixed[c] += static_cast<float>(share) * texel[c];
    }
  }
  return mixed;
}

// VTK blurs by three taps, 1.2 pixels apart, across and then upwards; of the last pass it enlarges
// all but a pixel of the picture to the picture.
TEST_F(ImagePass, Blurred)
{
  this->addBall();
  const Image plain = this->frame();
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkGaussianBlurPass> pass;
  pass->SetDelegatePass(steps);
  const Image blurred = this->frame(pass);
  constexpr std::pair<double, float> Taps[] = { { -1.2, 5.0f / 16 }, { 0.0, 6.0f / 16 },
    { 1.2, 5.0f / 16 } };
  const auto enlarged = [](int pixel) { return 0.5 + (pixel + 0.5) * (Side - 1.0) / Side; };
  Image across(Side, Side), expected(Side, Side);
  for (int y = 0; y < Side; ++y)
  {
    for (int x = 0; x < Side; ++x)
    {
      for (const auto& [offset, weight] : Taps)
      {
        const auto texel = mixedAt(plain, x + 0.5 + offset, y + 0.5);
        for (int c = 0; c < 4; ++c)
        {
          across.pixel(x, y)[c] += weight * texel[c];
        }
      }
    }
  }
  for (int y = 0; y < Side; ++y)
  {
    for (int x = 0; x < Side; ++x)
    {
      for (const auto& [offset, weight] : Taps)
      {
        const auto texel = mixedAt(across, enlarged(x), enlarged(y) + offset);
        for (int c = 0; c < 4; ++c)
        {
          expected.pixel(x, y)[c] += weight * texel[c];
        }
      }
    }
  }
  constexpr int Rim = 4; // beyond which the pass sees more than the picture
  constexpr int Inner = Side - 2 * Rim;
  EXPECT_GT(compare(blurred, plain, {}, 0.0, Channels::Rgb).Max, 0.1);
  expectSame(cropped(blurred, Rim, Rim, Inner, Inner), cropped(expected, Rim, Rim, Inner, Inner),
    2.0 / 255.0);
  pass->ReleaseGraphicsResources(this->Shown.Window);
}
} // namespace
