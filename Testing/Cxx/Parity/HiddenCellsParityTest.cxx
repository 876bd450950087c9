// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes with hidden cells, pixel by pixel against the CPU reference.
#include "CpuReference.h"
#include "GapScene.h"
#include "LitScene.h"

#include "vtkFloatArray.h"
#include "vtkPointData.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace
{
using namespace tetmarch::testing;

class HiddenParity : public testing::Test
{
protected:
  HiddenParity() { hide(this->Shown.Data, isCrumb); }

  LitScene Shown{ jitteredLattice(9, 0.15, 1, sineField()) };
};

TEST_F(HiddenParity, Unlit)
{
  this->Shown.property()->ShadeOff();
  expectParity(this->Shown);
  this->Shown.Mapper->SetAccuracyLevelToFast();
  expectParity(this->Shown);
}

TEST_F(HiddenParity, Shaded) { expectParity(this->Shown); }

TEST_F(HiddenParity, CellScalars)
{
  this->Shown.drawCellScalars();
  this->Shown.Mapper->SetShadowMethodToAtVertices();
  expectParity(this->Shown);
}

TEST_F(HiddenParity, TransparentRanges)
{
  setSpikyFunctions(this->Shown.property());
  expectParity(this->Shown);
  this->Shown.property()->ShadeOff();
  expectParity(this->Shown);
}

TEST_F(HiddenParity, ShadowsAndOcclusionAtVertices)
{
  this->Shown.Mapper->SetShadowMethodToAtVertices();
  this->Shown.Mapper->AmbientOcclusionOn();
  this->Shown.addGradientOpacity();
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

TEST_F(HiddenParity, BesideWhatIsNotFinite)
{
  vtkDataArray* scalars = this->Shown.Data->GetPointData()->GetScalars();
  for (vtkIdType i = 5; i < scalars->GetNumberOfTuples(); i += 23)
  {
    scalars->SetTuple1(i, std::numeric_limits<double>::quiet_NaN());
  }
  expectParity(this->Shown);
  this->Shown.Mapper->DrawNanCellsOn();
  this->Shown.property()->GetRGBTransferFunction()->SetNanColorRGBA(0.9, 0.2, 0.7, 0.4);
  expectParity(this->Shown);
}

TEST_F(HiddenParity, TheReferencePicture)
{
  vtkNew<vtkFloatArray> pixels;
  const Image drawn = this->Shown.render();
  ASSERT_TRUE(this->Shown.Mapper->RenderGroundTruth(this->Shown.Volume, pixels));
  const Image reference = Image::fromFloats(SceneSize, SceneSize, pixels->GetPointer(0));
  const Difference difference = compare(drawn, reference, regionsOf(this->Shown).Inside);
  EXPECT_LE(difference.Rms, 1.0 / 255.0) << difference.text();
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
