// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Each blend mode as vtkGPUVolumeRayCastMapper has it of the same field on an image. The field is
// linear, so that both interpolate it exactly; what is left is the rival's steps, by which it
// misses the end of a ray, its tables, and 8 bits.
#include "BlendScene.h"
#include "RivalImage.h"

#include "vtkAutoInit.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"

#include <gtest/gtest.h>
#include <iostream>

VTK_MODULE_INIT(vtkRenderingVolumeOpenGL2);

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 128;
constexpr int Points = 33;        // of the image, along an edge
constexpr double MostApart = 2.0; // RMS in 1/255

class BlendRival : public testing::Test
{
protected:
  BlendRival()
  {
    this->Rival->SetInputData(makeImage(Points, linearField()));
    this->Rival->SetAutoAdjustSampleDistances(0);
    this->Rival->SetSampleDistance(0.002f);
    this->Shown.property()->SetInterpolationTypeToLinear();
    this->Shown.property()->ShadeOff();
    this->Shown.Mapper->SetAverageIPScalarRange(0.3, 0.8);
    this->Rival->SetAverageIPScalarRange(0.3, 0.8);
  }

  Image ours(int mode)
  {
    this->Shown.Mapper->SetBlendMode(mode);
    this->Shown.Volume->SetMapper(this->Shown.Mapper);
    this->Shown.Window->Render();
    return this->Shown.frame();
  }
  Image rivals(int mode)
  {
    this->Rival->SetBlendMode(mode);
    this->Shown.Volume->SetMapper(this->Rival);
    this->Shown.Window->Render();
    return this->Shown.frame();
  }

  // Nearer to the rival's picture of that mode than any other mode's is.
  void expectSame(int mode, double mostApart = MostApart)
  {
    const Image rival = this->rivals(mode);
    const Image picture = this->ours(mode);
    const float black[3] = { 0, 0, 0 };
    const Mask seen = differsFrom(rival, black, 0.02f);
    const auto apart = [&](const Image& image)
    { return 255.0 * compare(image, rival, seen, 0.0, Channels::Rgb).Rms; };
    std::cout << "[ MEASURED ] " << this->Shown.Mapper->GetBlendModeAsString() << ": RMS "
              << apart(picture) << "/255\n";
    EXPECT_LE(apart(picture), mostApart);
    for (const int other : BlendModes)
    {
      if (other != mode)
      {
        EXPECT_GT(apart(this->ours(other)), 3 * MostApart)
          << this->Shown.Mapper->GetBlendModeAsString();
      }
    }
  }

  BlendScene Shown{ jitteredLattice(8, 0.1, 1, linearField()), Side, Side };
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> Rival;
};

TEST_F(BlendRival, Maximum) { this->expectSame(Mapper::MAXIMUM_INTENSITY_BLEND); }
TEST_F(BlendRival, Minimum) { this->expectSame(Mapper::MINIMUM_INTENSITY_BLEND); }
TEST_F(BlendRival, Average) { this->expectSame(Mapper::AVERAGE_INTENSITY_BLEND); }
TEST_F(BlendRival, Additive) { this->expectSame(Mapper::ADDITIVE_BLEND); }
// The rival misses surfaces within a step of the sides of the cube: there, one pixel in 300
// differs.
TEST_F(BlendRival, IsoSurface) { this->expectSame(Mapper::ISOSURFACE_BLEND, 2 * MostApart); }
} // namespace
