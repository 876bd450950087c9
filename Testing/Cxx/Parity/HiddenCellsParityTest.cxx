// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes with hidden cells, pixel by pixel against the CPU reference.
#include "CpuReference.h"
#include "GapScene.h"
#include "LitScene.h"

#include "vtkFloatArray.h"

#include <cmath>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 96;

class HiddenParity : public testing::Test
{
protected:
  HiddenParity() { hide(this->Shown.Data, isCrumb); }

  LitScene Shown{ jitteredLattice(9, 0.15, 1, sineField()), Side, Side };
};

TEST_F(HiddenParity, Shaded) { expectParity(this->Shown); }

TEST_F(HiddenParity, TransparentRanges)
{
  setSpikyFunctions(this->Shown.property());
  expectParity(this->Shown);
  this->Shown.property()->ShadeOff();
  expectParity(this->Shown);
}

TEST_F(HiddenParity, CameraInside)
{
  this->Shown.camera()->SetPosition(0.5, 0.45, 0.55);
  this->Shown.camera()->SetFocalPoint(0.9, 0.8, 0.2);
  this->Shown.camera()->SetClippingRange(0.01, 4.0);
  this->Shown.Mapper->SetShadowMethodToAtVertices();
  expectParity(this->Shown);
}

// Without light, which the ground truth has of every point and the picture of the faces.
TEST_F(HiddenParity, TheReferencePicture)
{
  this->Shown.property()->ShadeOff();
  vtkNew<vtkFloatArray> pixels;
  const Image drawn = this->Shown.render();
  ASSERT_TRUE(this->Shown.Mapper->RenderGroundTruth(this->Shown.Volume, pixels));
  const Image reference = Image::fromFloats(Side, Side, pixels->GetPointer(0));
  const Difference difference = compare(drawn, reference, regionsOf(this->Shown).Inside);
  EXPECT_LE(difference.Max, 1.0 / 255.0) << difference.text();
}

// Shadows along rays are sampled at random: the picture is as bright in the mean.
TEST_F(HiddenParity, ShadowsAlongRaysAreThoseAtVertices)
{
  this->Shown.Mapper->SetShadowMethodToAtVertices();
  const double atVertices = this->Shown.brightness();
  this->Shown.Mapper->SetShadowMethodToAlongRays();
  EXPECT_NEAR(this->Shown.brightness() / atVertices, 1.0, 0.03);
  this->Shown.Data->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  EXPECT_GT(std::abs(this->Shown.brightness() / atVertices - 1.0), 0.05);
}
} // namespace
