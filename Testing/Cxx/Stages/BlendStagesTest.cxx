// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a change of the blend mode or of its values makes anew, and what a mode doesn't need.
#include "vtkTetMarchFrameStatistics.h"

#include "BlendScene.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

struct Made
{
  vtkTypeInt64 Mesh, Scalars, Tables, Gradients, VertexLight, Bytes;
};

Made madeBy(const vtkTetMarchVolumeMapper* mapper)
{
  return { mapper->GetMeshBuilds(), mapper->GetScalarsBuilds(), mapper->GetTablesBuilds(),
    mapper->GetGradientsBuilds(), mapper->GetVertexLightBuilds(), mapper->GetUploadedBytes() };
}

class BlendStages : public testing::Test
{
protected:
  // Renders, and says whether the picture is another one.
  bool changes()
  {
    this->Before = madeBy(this->Shown.Mapper);
    const Image next = this->Shown.render();
    const bool other = this->Last.Rgba != next.Rgba;
    this->Last = next;
    this->After = madeBy(this->Shown.Mapper);
    EXPECT_EQ(this->After.Mesh, 1);
    EXPECT_EQ(this->After.Scalars, 1);
    return other;
  }
  vtkTypeInt64 tables() const { return this->After.Tables - this->Before.Tables; }
  bool uploads() const { return this->After.Bytes != this->Before.Bytes; }

  BlendScene Shown{ jitteredLattice(6, 0.15, 1, sineField()), 64, 64 };
  Image Last{ 64, 64 };
  Made Before{};
  Made After{};
};

TEST_F(BlendStages, ModesOfAKindDifferInNumbers)
{
  this->Shown.property()->ShadeOff();
  EXPECT_TRUE(this->changes());
  this->Shown.Mapper->SetBlendModeToMaximumIntensity();
  EXPECT_TRUE(this->changes());
  EXPECT_EQ(this->tables(), 0); // the law is that of composites
  EXPECT_FALSE(this->uploads());
  this->Shown.Mapper->SetBlendModeToMinimumIntensity();
  EXPECT_TRUE(this->changes());
  EXPECT_EQ(this->tables(), 0);
  this->Shown.Mapper->SetBlendModeToAdditive();
  EXPECT_TRUE(this->changes());
  EXPECT_EQ(this->tables(), 1);
  this->Shown.Mapper->SetBlendModeToAverageIntensity();
  EXPECT_TRUE(this->changes());
  EXPECT_EQ(this->tables(), 0);
  this->Shown.Mapper->SetAverageIPScalarRange(0.4, 0.6);
  EXPECT_TRUE(this->changes());
  EXPECT_EQ(this->tables(), 0);
  EXPECT_FALSE(this->uploads());
}

TEST_F(BlendStages, TheLawIsOfComposites)
{
  this->Shown.Mapper->SetBlendModeToMaximumIntensity();
  this->changes();
  this->Shown.Mapper->SetOpacityLawToStructured();
  EXPECT_FALSE(this->changes());
  EXPECT_EQ(this->tables(), 0);
  this->Shown.property()->SetScalarOpacityUnitDistance(0.01);
  EXPECT_FALSE(this->changes());
  this->Shown.Mapper->SetBlendModeToAdditive();
  this->changes();
  this->Shown.property()->SetScalarOpacityUnitDistance(1.0);
  EXPECT_TRUE(this->changes());
}

TEST_F(BlendStages, AnotherSurfaceIsAnotherNumber)
{
  this->Shown.Mapper->SetBlendModeToIsoSurface();
  EXPECT_TRUE(this->changes());
  this->Shown.setSurfaces({ 0.6 });
  EXPECT_TRUE(this->changes());
  EXPECT_EQ(this->tables(), 0);
  EXPECT_EQ(this->Shown.Mapper->GetMeshBuilds(), 1); // but other cells are visible
  this->Shown.setSurfaces({ 0.6, 0.6, 7.0 });
  EXPECT_FALSE(this->changes());
  this->Shown.setSurfaces({});
  EXPECT_TRUE(this->changes());
  EXPECT_EQ(compare(this->Last, Image(64, 64)).Max, 0.0);
}

// Only surfaces and composites need gradients, only composites light through the volume.
TEST_F(BlendStages, NothingIsMadeForWhatAModeHasNot)
{
  this->Shown.Mapper->SetShadowMethodToAtVertices();
  this->Shown.Mapper->SetAmbientOcclusion(true);
  this->Shown.addGradientOpacity();
  for (const int mode : { Mapper::MAXIMUM_INTENSITY_BLEND, Mapper::AVERAGE_INTENSITY_BLEND })
  {
    this->Shown.Mapper->SetBlendMode(mode);
    EXPECT_TRUE(this->changes());
    EXPECT_EQ(this->After.Gradients, 0);
    EXPECT_EQ(this->After.VertexLight, 0);
    for (const int view : { Mapper::VIEW_ILLUMINATION, Mapper::VIEW_GRADIENTS })
    {
      this->Shown.Mapper->SetViewMode(view);
      EXPECT_FALSE(this->changes());
      EXPECT_EQ(this->After.Gradients, 0);
    }
    this->Shown.Mapper->SetViewModeToPicture();
  }
  this->Shown.Mapper->SetBlendModeToIsoSurface();
  EXPECT_TRUE(this->changes());
  EXPECT_EQ(this->After.Gradients, 1);
  EXPECT_EQ(this->After.VertexLight, 0);
  this->Shown.Mapper->SetViewModeToIllumination();
  EXPECT_TRUE(this->changes());
  this->Shown.Mapper->SetViewModeToGradients();
  EXPECT_TRUE(this->changes());
  this->Shown.Mapper->SetViewModeToPicture();
  this->Shown.Mapper->SetBlendModeToComposite();
  EXPECT_TRUE(this->changes());
  EXPECT_EQ(this->After.VertexLight, 1);
}

// These modes are exact: their pictures are the same at each accuracy level.
TEST_F(BlendStages, LevelsDrawTheSame)
{
  for (const int mode : { Mapper::MAXIMUM_INTENSITY_BLEND, Mapper::AVERAGE_INTENSITY_BLEND,
         Mapper::ADDITIVE_BLEND, Mapper::ISOSURFACE_BLEND })
  {
    this->Shown.Mapper->SetBlendMode(mode);
    this->Shown.Mapper->SetAccuracyLevelToFast();
    const Image fast = this->Shown.render();
    this->Shown.Mapper->SetAccuracyLevelToReference();
    EXPECT_LE(compare(this->Shown.render(), fast).Max, 1.0 / 255.0)
      << this->Shown.Mapper->GetBlendModeAsString();
  }
}

// RenderGroundTruth() draws the mode, too. Composite without light: that of a picture is further
// from the light of every point.
TEST_F(BlendStages, TheReferenceIsOfTheMode)
{
  for (const int mode : BlendModes)
  {
    this->Shown.Mapper->SetBlendMode(mode);
    this->Shown.property()->SetShade(mode != vtkVolumeMapper::COMPOSITE_BLEND);
    this->Shown.render();
    ASSERT_TRUE(this->Shown.Mapper->CompareWithGroundTruth(this->Shown.Volume));
    EXPECT_LE(
      this->Shown.Mapper->GetLastFrameStatistics()->GetMean(vtkTetMarchFrameStatistics::TRUE_ERROR),
      2.0 / 255.0)
      << this->Shown.Mapper->GetBlendModeAsString();
  }
}
} // namespace
